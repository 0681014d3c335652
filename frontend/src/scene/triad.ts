/** A small cross of the world's axes in the corner of a viewport: tells where up is. */
import { basisOf } from './camera_pose'
import { AXIS_COLOURS } from './crosses'
import type { CameraPose } from './settings'

const SVG = 'http://www.w3.org/2000/svg'
const SIZE = 64
const ARM = 19
const LETTER = 26

export class Triad {
  readonly element = document.createElementNS(SVG, 'svg')
  readonly #axes: { line: SVGLineElement; text: SVGTextElement }[]

  constructor() {
    this.element.setAttribute('viewBox', `${-SIZE / 2} ${-SIZE / 2} ${SIZE} ${SIZE}`)
    this.element.setAttribute('class', 'stage-triad')
    this.element.setAttribute('aria-hidden', 'true')
    this.#axes = ['X', 'Y', 'Z'].map((letter, k) => {
      const line = document.createElementNS(SVG, 'line')
      const text = document.createElementNS(SVG, 'text')
      line.setAttribute('stroke', AXIS_COLOURS[k] ?? '')
      text.textContent = letter
      text.setAttribute('dominant-baseline', 'central')
      text.setAttribute('text-anchor', 'middle')
      this.element.append(line, text)
      return { line, text }
    })
  }

  update(pose: CameraPose): void {
    const { right, up } = basisOf(pose)
    this.#axes.forEach(({ line, text }, k) => {
      const [x, y] = [right.getComponent(k), -up.getComponent(k)]
      line.setAttribute('x2', (ARM * x).toFixed(1))
      line.setAttribute('y2', (ARM * y).toFixed(1))
      text.setAttribute('x', (LETTER * x).toFixed(1))
      text.setAttribute('y', (LETTER * y).toFixed(1))
      // An axis that points at the eye has no length: its letter would hide the cross.
      const short = Math.hypot(x, y) < 0.25
      // Never `visible`: that would outshine a panel that hides its views.
      text.setAttribute('visibility', short ? 'hidden' : 'inherit')
    })
  }
}
