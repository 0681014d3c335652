/** What the graphics of this machine can do. */

/** `soft`: drawn by the processor, so every pixel costs time. */
export type Tier = 'none' | 'soft' | 'full'

let known: Tier | undefined

/** What this browser can do; looked at once. */
export function tier(): Tier {
  known ??= look()
  return known
}

function look(): Tier {
  const context = document.createElement('canvas').getContext('webgl2')
  if (!context) return 'none'
  const names = context.getExtension('WEBGL_debug_renderer_info')
  const name = String(context.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : context.RENDERER))
  context.getExtension('WEBGL_lose_context')?.loseContext()
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name) ? 'soft' : 'full'
}
