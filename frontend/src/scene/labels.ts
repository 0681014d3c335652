/** Names in a viewport: page text that follows points of the scene. */
import { Vector3 } from 'three'
import { arrange, type Wanted } from './label_places'
import type { Rect } from './layouts'
import type { ViewCamera } from './view_camera'

export interface Label {
  /** In W [m]; read each time the viewport is drawn. */
  readonly point: Vector3
  readonly text: string
  readonly kind: 'frame' | 'problem' | 'selection'
  /** Where names would overlap, those of lower rank stay. */
  readonly rank: number
}

/** Rough width of a letter, what is about the text, and height of a name [px]. */
const GLYPH = 6.6
const AROUND = 12
const LINE = 17

/** What the buttons at the top left and the cross of axes cover [px]. */
const BUTTONS = { width: 156, height: 34 }
const CROSS = { width: 66, height: 66 }

const PLACE = new Vector3()

export class Labels {
  readonly element = document.createElement('div')
  #labels: readonly Label[] = []
  #spans: { readonly span: HTMLElement; at: string }[] = []

  constructor() {
    this.element.className = 'stage-labels'
    this.element.setAttribute('aria-hidden', 'true')
  }

  set(labels: readonly Label[]): void {
    this.#labels = labels
    this.#spans = labels.map(({ text, kind }) => {
      const span = document.createElement('span')
      span.textContent = text
      span.dataset.kind = kind
      return { span, at: '' }
    })
    this.element.replaceChildren(...this.#spans.map(({ span }) => span))
  }

  /** Bring the names to their points in a viewport of this size; those without a place of their own are left out. */
  update(view: ViewCamera, { width, height }: Rect): void {
    if (this.#labels.length === 0) return
    const seen: number[] = []
    const wanted: Wanted[] = []
    this.#labels.forEach(({ point, text, rank }, k) => {
      const { x, y, z } = view.project(point, PLACE)
      if (Math.abs(x) > 1 || Math.abs(y) > 1 || Math.abs(z) > 1) return
      seen.push(k)
      const place = { x: (0.5 + 0.5 * x) * width, y: (0.5 - 0.5 * y) * height }
      wanted.push({ ...place, width: Math.ceil(GLYPH * text.length + AROUND), height: LINE, rank })
    })
    const spots = arrange(wanted, { width, height }, [
      { x: 0, y: 0, ...BUTTONS },
      { x: 0, y: height - CROSS.height, ...CROSS },
    ])
    const places = new Map(seen.map((label, at) => [label, spots[at]]))
    this.#spans.forEach((entry, k) => {
      const spot = places.get(k)
      const at = spot ? `translate(${spot.left}px, ${spot.top}px)` : ''
      if (at === entry.at) return
      entry.at = at
      entry.span.style.visibility = spot ? 'inherit' : 'hidden'
      entry.span.style.transform = at
    })
  }
}
