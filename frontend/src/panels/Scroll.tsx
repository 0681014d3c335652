/** A part of a panel that scrolls, also from the keyboard. */
import type { ReactNode } from 'react'

interface ScrollProps {
  readonly label: string
  readonly className?: string
  readonly children: ReactNode
}

export function Scroll({ label, className = '', children }: ScrollProps) {
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must take the keyboard
    <section className={`scroll ${className}`} aria-label={label} tabIndex={0}>
      {children}
    </section>
  )
}
