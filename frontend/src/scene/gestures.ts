/** Pointer and wheel on one viewport, told as turning, moving, zooming and clicking. */

/** Places are in CSS px from the top left of the viewport. */
export interface GestureTarget {
  /** A drag or pinch begins at a place. */
  begin(x: number, y: number): void
  turn(right: number, down: number): void
  move(right: number, down: number): void
  /** Factor below 1: nearer. */
  zoom(x: number, y: number, factor: number): void
  click(x: number, y: number): void
  end(): void
}

/** A pointer that moved less than this has clicked [px]. */
const SLACK = 4

interface Held {
  x: number
  y: number
}

export class Gestures {
  readonly #held = new Map<number, Held>()
  #mode: 'turn' | 'move' | 'pinch' | null = null
  #moved = 0

  constructor(
    private readonly element: HTMLElement,
    private readonly target: GestureTarget,
  ) {
    element.addEventListener('pointerdown', event => this.#down(event))
    element.addEventListener('pointermove', event => this.#move(event))
    for (const type of ['pointerup', 'pointercancel'] as const) {
      element.addEventListener(type, event => this.#up(event))
    }
    element.addEventListener('contextmenu', event => event.preventDefault())
    element.addEventListener('wheel', event => this.#wheel(event), { passive: false })
  }

  #down(event: PointerEvent): void {
    this.element.focus({ preventScroll: true })
    this.element.setPointerCapture(event.pointerId)
    this.#held.set(event.pointerId, { x: event.offsetX, y: event.offsetY })
    if (this.#held.size > 1) {
      this.#mode = 'pinch'
      this.#moved = SLACK
    } else {
      this.#mode = event.button === 0 && !event.shiftKey ? 'turn' : 'move'
      this.#moved = 0
    }
    const { x, y } = this.#middle()
    this.target.begin(x, y)
    // The middle button would start the browser's own scrolling.
    if (event.button === 1) event.preventDefault()
  }

  #move(event: PointerEvent): void {
    const pointer = this.#held.get(event.pointerId)
    if (!pointer || !this.#mode) return
    const [before, span] = [this.#middle(), this.#span()]
    const [right, down] = [event.offsetX - pointer.x, event.offsetY - pointer.y]
    if (this.#moved < SLACK) {
      // Nothing happens until it is clear that this is no click; then the whole way counts.
      this.#moved = Math.hypot(right, down)
      if (this.#moved < SLACK) return
    }
    pointer.x = event.offsetX
    pointer.y = event.offsetY
    if (this.#mode === 'turn') this.target.turn(right, down)
    else if (this.#mode === 'move') this.target.move(right, down)
    else {
      const after = this.#middle()
      this.target.move(after.x - before.x, after.y - before.y)
      this.target.zoom(after.x, after.y, span / Math.max(this.#span(), 1))
    }
  }

  #up(event: PointerEvent): void {
    if (!this.#held.delete(event.pointerId)) return
    if (this.#held.size > 0) return
    if (event.type === 'pointerup' && this.#mode === 'turn' && this.#moved < SLACK) {
      this.target.click(event.offsetX, event.offsetY)
    }
    this.#mode = null
    this.target.end()
  }

  #wheel(event: WheelEvent): void {
    event.preventDefault()
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 33 : event.deltaY
    const factor = Math.exp(Math.max(-240, Math.min(240, pixels)) * 0.0016)
    this.target.zoom(event.offsetX, event.offsetY, factor)
    this.target.end()
  }

  #middle(): Held {
    const sum = { x: 0, y: 0 }
    for (const { x, y } of this.#held.values()) {
      sum.x += x / this.#held.size
      sum.y += y / this.#held.size
    }
    return sum
  }

  /** Distance of two fingers [px]. */
  #span(): number {
    const [a, b] = [...this.#held.values()]
    return a && b ? Math.max(1, Math.hypot(a.x - b.x, a.y - b.y)) : 1
  }
}
