/** A button with a small sheet of settings below it. */
import { type ReactNode, useRef, useState } from 'react'
import { usePopover } from '../studio/use_popover'

export function Drop({ title, children }: { title: string; children: ReactNode }) {
  const place = useRef<HTMLDetailsElement>(null)
  const [isOpen, setOpen] = useState(false)
  usePopover(place, isOpen, () => setOpen(false))
  return (
    <details className="drop" ref={place} open={isOpen} onToggle={event => setOpen(event.currentTarget.open)}>
      <summary>{title}</summary>
      <div className="drop-body">{children}</div>
    </details>
  )
}
