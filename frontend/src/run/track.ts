/** The bar of the timeline: marks, playhead and scrubbing; a slider for assistive technology. */
import type { Cursor } from './cursor'
import { type Marks, NO_MARKS, nearest, stepAt } from './marks'
import { words } from './words'

/** How near a click must be to a finding to land on it exactly [px]. */
const SNAP = 5

export class Track {
  readonly element = document.createElement('div')
  readonly #canvas = document.createElement('canvas')
  readonly #head = document.createElement('div')
  readonly #range = document.createElement('div')
  readonly #tip = document.createElement('div')
  readonly #cursor: Cursor
  readonly #observer: ResizeObserver
  readonly #scheme = matchMedia('(prefers-color-scheme: dark)')
  readonly #paint = () => this.#draw()
  #marks: Marks = NO_MARKS
  /** Length of the run for which the marks were drawn last. */
  #drawnEnd = Number.NaN
  #width = 0
  #playAfter = false
  #anchor: number | null = null

  constructor(cursor: Cursor) {
    this.#cursor = cursor
    this.element.className = 'timeline-track'
    this.element.tabIndex = 0
    this.element.setAttribute('role', 'slider')
    this.element.setAttribute('aria-label', words.time)
    this.element.setAttribute('aria-valuemin', '0')
    this.#range.className = 'timeline-range'
    this.#head.className = 'timeline-head'
    this.#tip.className = 'timeline-tip'
    this.#tip.hidden = true
    this.element.append(this.#canvas, this.#range, this.#head, this.#tip)
    this.element.addEventListener('pointerdown', event => this.#grab(event))
    this.element.addEventListener('pointermove', event => this.#drag(event))
    this.element.addEventListener('pointerup', () => this.#drop())
    this.element.addEventListener('pointercancel', () => this.#drop())
    this.element.addEventListener('pointerleave', () => {
      this.#tip.hidden = true
    })
    this.#observer = new ResizeObserver(() => this.#resize())
    this.#observer.observe(this.element)
    this.#scheme.addEventListener('change', this.#paint)
  }

  show(marks: Marks): void {
    if (marks === this.#marks) return
    this.#marks = marks
    this.#draw()
  }

  /** Follow the cursor's time; cheap enough for every frame. */
  follow(): void {
    const { time, end } = this.#cursor
    this.#head.style.transform = `translateX(${this.#x(time)}px)`
    const now = time.toFixed(1)
    if (this.element.getAttribute('aria-valuenow') === now) return
    const step = stepAt(this.#marks, time)
    const text = step ? `${words.line(step.line)} ${step.text}` : ''
    this.element.setAttribute('aria-valuenow', now)
    this.element.setAttribute('aria-valuetext', words.valueText(time, end, text))
  }

  /** Take over a new length of the run or a new loop. */
  relate(): void {
    this.element.setAttribute('aria-valuemax', this.#cursor.end.toFixed(1))
    const loop = this.#cursor.loop
    this.#range.hidden = loop === null
    if (loop) {
      this.#range.style.left = `${this.#x(loop[0])}px`
      this.#range.style.width = `${this.#x(loop[1]) - this.#x(loop[0])}px`
    }
    // A live run grows with every frame: without marks nothing that is drawn moves.
    const marked =
      this.#marks.steps.length > 0 || this.#marks.findings.length > 0 || this.#marks.inputs.length > 0
    if (marked && this.#drawnEnd !== this.#cursor.end) this.#draw()
  }

  destroy(): void {
    this.#observer.disconnect()
    this.#scheme.removeEventListener('change', this.#paint)
    this.element.remove()
  }

  #x(time: number): number {
    return this.#cursor.end > 0 ? (this.#width * time) / this.#cursor.end : 0
  }

  #time(event: PointerEvent): number {
    const left = this.element.getBoundingClientRect().left
    const share = (event.clientX - left) / Math.max(this.#width, 1)
    return Math.min(Math.max(share, 0), 1) * this.#cursor.end
  }

  #grab(event: PointerEvent): void {
    if (event.button !== 0) return
    this.element.setPointerCapture(event.pointerId)
    const time = this.#time(event)
    if (event.shiftKey) {
      this.#anchor = time
      return
    }
    this.#playAfter = this.#cursor.playing
    this.#cursor.pause()
    const found = nearest(this.#marks.findings, time, this.#reach())
    this.#cursor.seek(found ? found.time : time)
  }

  #drag(event: PointerEvent): void {
    const time = this.#time(event)
    this.#tell(time)
    if (!this.element.hasPointerCapture(event.pointerId)) return
    if (this.#anchor === null) this.#cursor.seek(time)
    else if (time !== this.#anchor) {
      this.#cursor.setLoop([Math.min(time, this.#anchor), Math.max(time, this.#anchor)])
    }
  }

  #drop(): void {
    this.#anchor = null
    if (this.#playAfter) this.#cursor.play()
    this.#playAfter = false
  }

  #tell(time: number): void {
    const found = nearest(this.#marks.findings, time, this.#reach())
    const step = stepAt(this.#marks, time)
    const input = nearest(this.#marks.inputs, time, this.#reach())
    const what = found
      ? found.text
      : input
        ? words.input(input.text)
        : step
          ? `${words.line(step.line)} · ${step.text}`
          : ''
    this.#tip.textContent = `${time.toFixed(2)} s${what ? ` · ${what}` : ''}`
    this.#tip.hidden = false
    const x = this.#x(time)
    this.#tip.classList.toggle('timeline-tip-left', x > this.#width / 2)
    this.#tip.style.transform = `translateX(${x}px)`
  }

  #reach(): number {
    return (SNAP / Math.max(this.#width, 1)) * this.#cursor.end
  }

  #resize(): void {
    this.#width = this.element.clientWidth
    this.#draw()
    this.relate()
    this.follow()
  }

  #draw(): void {
    this.#drawnEnd = this.#cursor.end
    const ratio = window.devicePixelRatio || 1
    const height = this.element.clientHeight
    this.#canvas.width = Math.round(this.#width * ratio)
    this.#canvas.height = Math.round(height * ratio)
    const context = this.#canvas.getContext('2d')
    if (!context || this.#width === 0) return
    const style = getComputedStyle(this.element)
    const colour = (name: string) => style.getPropertyValue(name).trim() || 'gray'
    context.scale(ratio, ratio)
    context.fillStyle = colour('--line')
    context.fillRect(0, height / 2 - 2, this.#width, 4)
    context.fillStyle = colour('--accent')
    for (const step of this.#marks.steps) {
      const x = this.#x(step.time)
      // A gap of a pixel between neighbours, where there is room for one.
      const width = Math.max(this.#x(step.end) - x - 1, 1)
      context.globalAlpha = step.kind === 'move' ? 0.75 : 0.35
      context.fillRect(x, height / 2 - 5, width, 10)
    }
    context.globalAlpha = 1
    context.fillStyle = colour('--ghost')
    for (const { time } of this.#marks.inputs) {
      const x = this.#x(time)
      context.fillRect(x - 1, height / 2 - 2, 2, height / 2 + 2)
      // A foot tells presses from findings, which have a head.
      context.fillRect(x - 3, height - 4, 6, 4)
    }
    for (const found of this.#marks.findings) {
      context.fillStyle = colour(`--${found.severity === 'hint' ? 'info' : found.severity}`)
      const x = this.#x(found.time)
      context.fillRect(x - 1, 2, 2, height - 4)
      // A head tells findings from steps without their colour.
      context.beginPath()
      context.moveTo(x - 4, 0)
      context.lineTo(x + 4, 0)
      context.lineTo(x, 7)
      context.fill()
    }
  }
}
