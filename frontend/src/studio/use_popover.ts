/** What opens over the page closes on a click outside and on Escape; the keyboard goes back to what opened it. */
import { type RefObject, useEffect, useRef } from 'react'

/** `place` holds both the popover and the button that opened it. */
export function usePopover<T extends HTMLElement>(
  place: RefObject<T | null>,
  isOpen: boolean,
  close: () => void,
): void {
  const newest = useRef(close)
  newest.current = close
  useEffect(() => {
    if (!isOpen) return
    const stop = new AbortController()
    const { signal } = stop
    const isInside = (target: EventTarget | null) =>
      target instanceof Node && place.current?.contains(target) === true
    const outside = (event: Event) => {
      if (!isInside(event.target)) newest.current()
    }
    const dismiss = (event: KeyboardEvent) => {
      if (event.key !== 'Escape' || event.defaultPrevented) return
      const opener = place.current?.querySelector<HTMLElement>('summary, [aria-expanded="true"]')
      const inside = isInside(document.activeElement) || document.activeElement === document.body
      newest.current()
      if (inside) opener?.focus()
      event.preventDefault()
      event.stopPropagation()
    }
    // Before panels and commands hear of it: Escape closes what is on top, and that only.
    addEventListener('pointerdown', outside, { signal, capture: true })
    addEventListener('keydown', dismiss, { signal, capture: true })
    return () => stop.abort()
  }, [isOpen, place])
}
