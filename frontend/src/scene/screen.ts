/** The canvas with its viewports: lays them out, draws those that are out of date, hands on what the user does. */
import type { Ray } from 'three'
import { FrameTimes } from './frame_times'
import { PLACES, rectsOf } from './layouts'
import { Listeners } from './listeners'
import { onNextFrame } from './next_frame'
import type { Overlay } from './overlay'
import { Painter } from './painter'
import { pick } from './picker'
import type { Scenery } from './scenery'
import type { Layout, PickListener, StageState, StageStats } from './settings'
import { tier } from './tier'
import { pressKey } from './view_keys'
import { Viewport, type ViewportContext } from './viewport'
import type { Words } from './words'

export class Screen {
  readonly views: readonly Viewport[]
  readonly picked = new Listeners<Parameters<PickListener>>()
  readonly drawn = new Listeners<[]>()
  readonly changed = new Listeners<[]>()
  readonly #painter = tier() === 'none' ? null : new Painter()
  readonly #times = new FrameTimes()
  readonly #sizes = new ResizeObserver(() => this.#resize())
  #layout: Layout = '4'
  /** Calls off the frame that has been asked for; null while none is. */
  #callOff: (() => void) | null = null
  #turn = 0
  /** The graphics are ready; before that, drawing would hold up the page. */
  #prepared = false
  #width = 0
  #height = 0

  constructor(
    private readonly host: HTMLElement,
    private readonly scenery: Scenery,
    private readonly overlay: Overlay,
    private readonly words: Words,
    reducedMotion: boolean,
  ) {
    const context = this.#context(reducedMotion)
    this.views = PLACES.map(place => new Viewport(place, context))
    for (const view of this.views) {
      view.element.setAttribute('aria-describedby', overlay.describedBy)
      view.element.addEventListener('keydown', event => this.#key(view, event))
    }
    host.append(...this.views.map(({ frame }) => frame))
    if (this.#painter) this.#mount(this.#painter)
    else overlay.message(words.noWebGL)
    this.#sizes.observe(host)
    this.#resize()
  }

  get layout(): Layout {
    return this.#layout
  }

  set layout(layout: Layout) {
    if (layout === this.#layout) return
    this.#layout = layout
    this.#place()
    if (!this.#painter || !this.#canDraw()) return
    // The places are others now: all is drawn at once, or the picture would flicker.
    this.#painter.clear()
    this.#paint(this.#painter, this.shown, performance.now())
  }

  get state(): StageState {
    return { layout: this.#layout, views: this.views.map(({ pilot }) => pilot.state) }
  }

  restore({ layout, views }: StageState): void {
    this.layout = layout
    for (const [k, { pilot }] of this.views.entries()) {
      const state = views[k]
      if (state) pilot.restore(state)
    }
  }

  /** Viewports that the layout has. */
  get shown(): readonly Viewport[] {
    return this.views.filter(({ rect }) => rect !== null)
  }

  /** A viewport by its index or its name. */
  view(which: number | string): Viewport | undefined {
    if (typeof which === 'number') return this.views[which]
    return this.views.find(({ id }) => id === which.toLowerCase())
  }

  /** Every picture is out of date. */
  redraw(): void {
    for (const view of this.views) view.dirty = true
    this.request()
  }

  /** Names have changed. */
  relabel(): void {
    const labels = this.scenery.labels()
    for (const view of this.views) view.labels.set(labels)
    this.redraw()
  }

  /** Meshes have come: views that nobody has moved show all again. */
  reformed(): void {
    const points = this.scenery.homePoints()
    for (const view of this.views) view.pilot.grown(points)
    this.relabel()
  }

  /** Draw at the next animation frame. */
  request(): void {
    if (this.#painter) this.#callOff ??= onNextFrame(() => this.draw())
  }

  /** Draw what is out of date; as much of it as one frame has time for. */
  draw(): void {
    this.#callOff?.()
    this.#callOff = null
    if (!this.#painter || !this.#canDraw()) return
    const start = performance.now()
    const gliding = this.views.map(view => view.pilot.step(start)).includes(true)
    const chosen = this.#chosen()
    if (chosen.length > 0) this.#paint(this.#painter, chosen, start)
    if (gliding || this.#waiting().length > 0) this.request()
  }

  /** Draw all views now. */
  drawAll(): void {
    this.#callOff?.()
    this.#callOff = null
    if (this.#painter && this.#canDraw()) this.#paint(this.#painter, this.shown, performance.now())
  }

  stats(): StageStats {
    return {
      frames: this.#times.count,
      p50: this.#times.quantile(0.5),
      p95: this.#times.quantile(0.95),
      triangles: this.#painter?.triangles ?? 0,
      calls: this.#painter?.calls ?? 0,
      software: tier() === 'soft',
      views: this.shown.length,
      pending: this.#painter ? this.#waiting().length : 0,
    }
  }

  dispose(): void {
    this.#callOff?.()
    this.#sizes.disconnect()
    for (const listeners of [this.picked, this.drawn, this.changed]) listeners.clear()
    this.#painter?.dispose()
    for (const { frame } of this.views) frame.remove()
  }

  #paint(painter: Painter, views: readonly Viewport[], start: number): void {
    painter.begin()
    painter.castShadows(this.scenery.shadow, this.scenery.scene)
    for (const view of views) {
      if (!view.rect) continue
      const camera = view.pilot.view
      painter.draw(this.scenery.scene, camera.camera, view.rect)
      view.labels.update(camera, view.rect)
      view.dirty = false
    }
    this.#times.add(performance.now() - start)
    this.drawn.tell()
  }

  #canDraw(): boolean {
    return this.#prepared && !this.#painter?.lost
  }

  #waiting(): readonly Viewport[] {
    return this.shown.filter(({ dirty }) => dirty)
  }

  /** All that wait; where the processor draws, the foremost one and one of the others in turn. */
  #chosen(): readonly Viewport[] {
    const waiting = this.#waiting()
    if (tier() !== 'soft' || waiting.length < 3) return waiting
    const first = waiting.find(({ held }) => held) ?? waiting[0]
    const others = waiting.filter(view => view !== first)
    this.#turn += 1
    const next = others[this.#turn % others.length]
    return [first, next].filter(view => view !== undefined)
  }

  #mount(painter: Painter): void {
    this.host.prepend(painter.canvas)
    painter.prepare(this.scenery.samples(), this.scenery.shadow).finally(() => {
      this.#prepared = true
      this.redraw()
    })
    painter.canvas.addEventListener('webglcontextlost', event => {
      event.preventDefault()
      this.overlay.message(this.words.contextLost)
    })
    painter.canvas.addEventListener('webglcontextrestored', () => {
      this.overlay.message(null)
      this.scenery.shadow.touch()
      this.redraw()
    })
  }

  #resize(): void {
    const [width, height] = [this.host.clientWidth, this.host.clientHeight]
    if (width === 0 || height === 0) return
    this.#width = width
    this.#height = height
    this.#painter?.resize(width, height)
    this.#place()
    // The canvas is empty now: all of it is drawn at once, or it would flicker.
    if (this.#painter && this.#canDraw()) this.#paint(this.#painter, this.shown, performance.now())
  }

  #place(): void {
    const rects = rectsOf(this.#layout, this.#width, this.#height)
    this.views.forEach((view, k) => {
      view.place(rects[k] ?? null)
    })
    this.redraw()
  }

  #key(view: Viewport, event: KeyboardEvent): void {
    const acted = pressKey(view.pilot, event, {
      fitSelection: () => view.pilot.fit(this.scenery.points(this.scenery.selected)),
      fitAll: () => view.pilot.fitAll(this.scenery.homePoints()),
    })
    if (!acted) return
    event.preventDefault()
    event.stopPropagation()
    this.changed.tell()
  }

  #context(reducedMotion: boolean): ViewportContext {
    return {
      words: this.words,
      reducedMotion,
      hit: (ray: Ray) => pick(this.scenery.bodies, ray)?.point ?? null,
      floor: () => this.scenery.floor.height,
      all: () => this.scenery.homePoints(),
      dirty: view => {
        view.dirty = true
        this.request()
      },
      changed: () => this.changed.tell(),
      click: (view, ray) => {
        const hit = pick(this.scenery.bodies, ray)
        this.picked.tell(hit?.body ?? -1, hit?.point.toArray() ?? null, this.views.indexOf(view))
      },
    }
  }
}
