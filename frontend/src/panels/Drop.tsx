/** A button with a small sheet of settings below it. */
import { type MouseEvent, type ReactNode, useRef, useState } from 'react'
import { usePopover } from '../studio/use_popover'

export function Drop({ title, children }: { title: string; children: ReactNode }) {
  const place = useRef<HTMLDetailsElement>(null)
  const [isOpen, setOpen] = useState(false)
  usePopover(place, isOpen, () => setOpen(false))
  // The browser tells of `open` only after it has shown the sheet: who is quick with Escape would not be heard.
  const turn = (event: MouseEvent) => {
    event.preventDefault()
    setOpen(!isOpen)
  }
  return (
    <details className="drop" ref={place} open={isOpen} onToggle={event => setOpen(event.currentTarget.open)}>
      {/* biome-ignore lint/a11y/noStaticElementInteractions: a summary is a button */}
      <summary onClick={turn}>{title}</summary>
      <div className="drop-body">{children}</div>
    </details>
  )
}
