/** Draws viewports on one canvas, as far as the graphics of this machine allow. */
import { type Camera, OrthographicCamera, type Scene, WebGLRenderer } from 'three'
import type { Rect } from './layouts'
import type { Shadow } from './shadow'
import { tier } from './tier'

export class Painter {
  readonly canvas = document.createElement('canvas')
  readonly #renderer: WebGLRenderer
  #height = 0

  /** Throws where there is no WebGL 2: ask `tier` first. */
  constructor() {
    const soft = tier() === 'soft'
    this.canvas.className = 'stage-canvas'
    // The viewports over it are what has names and takes keys.
    this.canvas.setAttribute('aria-hidden', 'true')
    this.#renderer = new WebGLRenderer({
      canvas: this.canvas,
      antialias: !soft,
      alpha: false,
      // Arms are marked in it: a ghost is drawn beside them, never upon them.
      stencil: true,
      // A frame may draw some of the viewports only: the others must last.
      preserveDrawingBuffer: true,
      powerPreference: 'high-performance',
    })
    this.#renderer.setPixelRatio(soft ? 1 : Math.min(devicePixelRatio, 2))
    this.#renderer.info.autoReset = false
  }

  get triangles(): number {
    return this.#renderer.info.render.triangles
  }

  get calls(): number {
    return this.#renderer.info.render.calls
  }

  get lost(): boolean {
    return this.#renderer.getContext().isContextLost()
  }

  /** Size of the canvas [CSS px]. */
  resize(width: number, height: number): void {
    this.#height = height
    this.#renderer.setSize(width, height, false)
  }

  /** Empty all of the canvas: viewports have moved, and what was drawn between them would stay. */
  clear(): void {
    this.#renderer.setScissorTest(false)
    this.#renderer.setClearAlpha(0)
    this.#renderer.clear()
    this.#renderer.setClearAlpha(1)
  }

  /** Have the graphics ready for what is in these scenes, beside everything else the page does meanwhile. */
  async prepare(scenes: readonly Scene[], shadow: Shadow): Promise<void> {
    shadow.prepare(this.#renderer)
    const camera = new OrthographicCamera()
    await Promise.all(scenes.map(scene => this.#renderer.compileAsync(scene, camera)))
  }

  /** A frame begins: counts start anew. */
  begin(): void {
    this.#renderer.info.reset()
  }

  /** Bring shadows up to date before viewports are drawn. */
  castShadows(shadow: Shadow, scene: Scene): void {
    shadow.update(this.#renderer, scene)
  }

  draw(scene: Scene, camera: Camera, { x, y, width, height }: Rect): void {
    const bottom = this.#height - y - height
    // Said each time: a context that was lost and restored has forgotten it.
    this.#renderer.setScissorTest(true)
    this.#renderer.setViewport(x, bottom, width, height)
    this.#renderer.setScissor(x, bottom, width, height)
    this.#renderer.render(scene, camera)
  }

  dispose(): void {
    this.#renderer.dispose()
    this.#renderer.forceContextLoss()
    this.canvas.remove()
  }
}
