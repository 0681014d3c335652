/** One viewport: what lies over the canvas there, and the camera behind it. */
import { type Ray, Vector3 } from 'three'
import { Gestures } from './gestures'
import { Labels } from './labels'
import type { Rect } from './layouts'
import { Pilot, type PilotContext } from './pilot'
import type { Point, Preset, Projection } from './settings'
import { Toolbar } from './toolbar'
import { Triad } from './triad'
import type { Words } from './words'

/** What a viewport needs to know of the stage, and tells it. */
export interface ViewportContext extends PilotContext {
  readonly words: Words
  /** What `fit` shows. */
  all(): Vector3[]
  /** Its picture is out of date. */
  dirty(viewport: Viewport): void
  /** The user has changed its view. */
  changed(): void
  click(viewport: Viewport, ray: Ray): void
}

export class Viewport {
  readonly frame = document.createElement('div')
  /** The drawing area: takes focus, keys and pointer. */
  readonly element = document.createElement('div')
  readonly labels = new Labels()
  readonly pilot: Pilot
  readonly #triad = new Triad()
  readonly #toolbar: Toolbar
  #rect: Rect | null = null
  /** Still to be drawn. */
  dirty = true
  /** The user has hold of it. */
  held = false

  constructor(
    readonly id: Exclude<Preset, 'custom'>,
    private readonly context: ViewportContext,
  ) {
    this.pilot = new Pilot(
      id,
      context,
      () => this.#moved(),
      () => this.#renamed(),
    )
    this.frame.className = 'stage-view'
    this.frame.dataset.view = id
    this.element.className = 'stage-surface'
    this.element.tabIndex = 0
    this.element.setAttribute('role', 'application')
    this.#toolbar = new Toolbar(
      {
        look: preset => this.#changed(() => this.pilot.look(preset)),
        switchProjection: () => this.#changed(() => this.pilot.switchProjection()),
        fit: () => this.#changed(() => this.pilot.fitAll(context.all())),
      },
      context.words,
    )
    this.frame.append(this.labels.element, this.#triad.element, this.element, this.#toolbar.element)
    this.#listen()
    this.#renamed()
  }

  get preset(): Preset {
    return this.pilot.preset
  }

  get projection(): Projection {
    return this.pilot.view.projection
  }

  /** Where it lies on the stage; null while the layout leaves it out. */
  get rect(): Rect | null {
    return this.#rect
  }

  place(rect: Rect | null): void {
    this.#rect = rect && rect.width > 0 && rect.height > 0 ? rect : null
    this.frame.hidden = this.#rect === null
    if (!this.#rect) return
    const { x, y, width, height } = this.#rect
    Object.assign(this.frame.style, {
      left: `${x}px`,
      top: `${y}px`,
      width: `${width}px`,
      height: `${height}px`,
    })
    this.pilot.resize(width, height)
  }

  /** Where a point of W lies [CSS px from the top left]; null when it is behind the eye or nothing is shown. */
  project(point: Vector3): Point | null {
    if (!this.#rect) return null
    const { x, y, z } = this.pilot.view.project(point, new Vector3())
    if (Math.abs(z) > 1) return null
    return { x: (0.5 + 0.5 * x) * this.#rect.width, y: (0.5 - 0.5 * y) * this.#rect.height }
  }

  #listen(): void {
    const { pilot } = this
    const height = () => this.#rect?.height ?? 1
    new Gestures(this.element, {
      begin: (x, y) => {
        this.held = true
        pilot.anchorAt(x, y)
      },
      turn: (right, down) => pilot.turn((-right / height()) * Math.PI, (down / height()) * Math.PI),
      move: (right, down) => pilot.move(right / height(), -down / height()),
      zoom: (x, y, factor) => {
        pilot.anchorAt(x, y)
        pilot.zoom(factor)
      },
      click: (x, y) => this.context.click(this, pilot.sight(x, y)),
      end: () => {
        this.held = false
        this.context.changed()
      },
    })
  }

  #changed(act: () => void): void {
    act()
    this.context.changed()
  }

  #moved(): void {
    this.#triad.update(this.pilot.view.pose)
    this.context.dirty(this)
  }

  #renamed(): void {
    const { words } = this.context
    this.element.setAttribute('aria-label', words.viewName(words.presets[this.preset]))
    this.#toolbar.show(this.preset, this.projection)
  }
}
