/** Names in a viewport: page text that follows points of the scene. */
import { Vector3 } from 'three'
import type { Rect } from './layouts'
import type { ViewCamera } from './view_camera'

export interface Label {
  /** In W [m]; read each time the viewport is drawn. */
  readonly point: Vector3
  readonly text: string
  readonly kind: 'frame' | 'problem' | 'selection'
}

/** Rough width of a letter, height of a name and its gap [px]. */
const GLYPH = 7
const LINE = 24

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

  /** Bring the names to their points in a viewport of this size. */
  update(view: ViewCamera, { width, height }: Rect): void {
    this.#labels.forEach(({ point, text }, k) => {
      const entry = this.#spans[k]
      if (!entry) return
      const { x, y, z } = view.project(point, PLACE)
      const inside = Math.abs(x) <= 1 && Math.abs(y) <= 1 && Math.abs(z) <= 1
      const [left, top] = [Math.round((0.5 + 0.5 * x) * width), Math.round((0.5 - 0.5 * y) * height)]
      // A name that would run out of the picture stands to the left of its point, or above it.
      const side = left + GLYPH * text.length > width ? ' translateX(calc(-100% - 12px))' : ''
      const lift = top + LINE > height ? ' translateY(calc(-100% - 8px))' : ''
      const at = inside ? `translate(${left}px, ${top}px)${side}${lift}` : ''
      if (at === entry.at) return
      entry.at = at
      entry.span.style.visibility = inside ? 'inherit' : 'hidden'
      entry.span.style.transform = at
    })
  }
}
