import react from '@vitejs/plugin-react'
import { defineConfig } from 'vitest/config'

// The studio: an index page, its chunks and styles, all served by `ropsim studio`.
export default defineConfig({
  plugins: [react()],
  base: '/',
  html: { cspNonce: '__CSP_NONCE__' },
  build: {
    outDir: 'dist/studio',
    emptyOutDir: true,
    target: 'es2022',
    sourcemap: false,
    license: { fileName: 'licenses.md' },
    chunkSizeWarningLimit: 1500,
    modulePreload: { polyfill: false },
  },
  // A worker runs many files: one for each file takes three times as much of the processor, to import again.
  test: {
    environment: 'node',
    include: ['src/**/*.test.ts', 'src/**/*.test.tsx'],
    setupFiles: ['src/test_frames.ts'],
    pool: 'threads',
    isolate: false,
  },
})
