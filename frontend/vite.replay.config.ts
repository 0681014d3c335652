import { readFileSync } from 'node:fs'
import { defineConfig } from 'vite'

// The notices of what is bundled travel with the script into every report.
const notices = ['three', 'uplot'].map(
  name => `${name}: ${readFileSync(`node_modules/${name}/LICENSE`, 'utf8')}`,
)

// The replay: one script and one style sheet that `ropsim run --report` writes into its page.
export default defineConfig({
  build: {
    outDir: 'dist/replay',
    emptyOutDir: true,
    target: 'es2022',
    sourcemap: false,
    license: { fileName: 'licenses.md' },
    cssCodeSplit: false,
    chunkSizeWarningLimit: 1500,
    lib: {
      entry: 'src/replay/main.ts',
      formats: ['iife'],
      name: 'ropsimReplay',
      fileName: () => 'replay.js',
      cssFileName: 'replay',
    },
    rolldownOptions: { output: { postBanner: `/*!\n${notices.join('\n')}*/` } },
  },
  define: { 'process.env.NODE_ENV': '"production"' },
})
