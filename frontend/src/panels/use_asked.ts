/** A value that a live run is asked for: it shows at once, and again what the run says when that has heard of it. */
import { useEffect, useState } from 'react'

/** After this time a control shows again what the run says [ms]. */
const PATIENCE = 2000

/**
 * Show what was asked for last until the run has come to it: it is a little behind, and a control must not jump
 * back in between, nor count its next step from there.
 *
 * @param told what the run says
 * @param send passes on what is asked for
 */
export function useAsked(
  told: number,
  send: (value: number) => void,
): readonly [number, (value: number) => void] {
  const [asked, setAsked] = useState<number | null>(null)
  useEffect(() => {
    if (asked === null) return
    const timer = setTimeout(() => setAsked(null), told === asked ? 0 : PATIENCE)
    return () => clearTimeout(timer)
  }, [asked, told])
  const ask = (value: number) => {
    setAsked(value)
    send(value)
  }
  return [asked ?? told, ask]
}
