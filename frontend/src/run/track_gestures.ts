/** What pointers and wheel do on the timeline: scrub, choose a stretch, zoom, shift. */

/** What is done at places across the element [px]. */
export interface TrackActions {
  readonly grasp: (x: number) => void
  readonly drag: (x: number) => void
  readonly drop: () => void
  readonly select: (from: number, to: number) => void
  readonly hover: (x: number, y: number) => void
  readonly leave: () => void
  readonly zoom: (factor: number, x: number) => void
  readonly pan: (pixels: number) => void
}

/** When the wheel zooms: a page that scrolls keeps the plain wheel for itself. */
export type WheelZoom = 'always' | 'with Ctrl'

/** Zoom of one notch of a wheel (100 px). */
const NOTCH = 1.35
const PIXELS_OF_A_LINE = 16

/** Hear of pointers and wheel on an element; returns the way to stop that. */
export function trackGestures(element: HTMLElement, wheel: WheelZoom, actions: TrackActions): () => void {
  const pointers = new Map<number, number>()
  let anchor: number | null = null
  const stop = new AbortController()
  const { signal } = stop
  const xOf = (event: MouseEvent) => event.clientX - element.getBoundingClientRect().left
  const yOf = (event: MouseEvent) => event.clientY - element.getBoundingClientRect().top

  const down = (event: PointerEvent) => {
    if (event.button !== 0) return
    element.setPointerCapture(event.pointerId)
    pointers.set(event.pointerId, xOf(event))
    if (pointers.size > 1) {
      actions.drop()
      anchor = null
    } else if (event.shiftKey) anchor = xOf(event)
    else actions.grasp(xOf(event))
  }
  const move = (event: PointerEvent) => {
    const x = xOf(event)
    actions.hover(x, yOf(event))
    if (!pointers.has(event.pointerId)) return
    if (pointers.size === 2) {
      const [first = 0, second = 0] = pointers.values()
      pointers.set(event.pointerId, x)
      const [left = 0, right = 0] = pointers.values()
      const apart = Math.abs(second - first)
      if (apart > 8) actions.zoom(Math.abs(right - left) / apart, (left + right) / 2)
    } else if (anchor !== null) actions.select(anchor, x)
    else if (pointers.size === 1) actions.drag(x)
  }
  const up = (event: PointerEvent) => {
    if (!pointers.delete(event.pointerId)) return
    if (pointers.size === 0 && anchor === null) actions.drop()
    anchor = null
  }
  const turn = (event: WheelEvent) => {
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? PIXELS_OF_A_LINE : 1
    // A touchpad's pinch comes as a wheel with Ctrl.
    const zooms = event.ctrlKey || (wheel === 'always' && !event.shiftKey)
    const across = event.shiftKey && event.deltaX === 0 ? event.deltaY : event.deltaX
    if (Math.abs(event.deltaX) > Math.abs(event.deltaY) || event.shiftKey) actions.pan(across * unit)
    else if (zooms) actions.zoom(NOTCH ** ((-event.deltaY * unit) / 100), xOf(event))
    else return
    event.preventDefault()
  }
  element.addEventListener('pointerdown', down, { signal })
  element.addEventListener('pointermove', move, { signal })
  element.addEventListener('pointerup', up, { signal })
  element.addEventListener('pointercancel', up, { signal })
  element.addEventListener('pointerleave', actions.leave, { signal })
  element.addEventListener('wheel', turn, { signal, passive: false })
  return () => stop.abort()
}
