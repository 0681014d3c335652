/** Keys, leaving, losing focus: what concerns the page as a whole. */
import { useEffect } from 'react'
import type { Studio } from './studio'

export function usePageEvents(studio: Studio): void {
  useEffect(() => {
    const off = new AbortController()
    const { signal } = off
    const sensor = (event: KeyboardEvent) => {
      if (studio.signals.key(event)) {
        event.preventDefault()
        event.stopPropagation()
      }
    }
    // Armed sensors come first, wherever the focus is; commands come last, after panels had their chance.
    addEventListener('keydown', sensor, { signal, capture: true })
    addEventListener('keyup', sensor, { signal, capture: true })
    addEventListener(
      'keydown',
      event => {
        if (studio.commands.key(event)) event.preventDefault()
      },
      { signal },
    )
    addEventListener('blur', () => studio.signals.blur(), { signal })
    addEventListener('pagehide', () => studio.desk.flush(), { signal })
    document.addEventListener(
      'visibilitychange',
      () => {
        if (document.visibilityState === 'hidden') studio.desk.flush()
      },
      { signal },
    )
    addEventListener(
      'beforeunload',
      event => {
        studio.desk.flush()
        if (!studio.desk.delivered) event.preventDefault()
      },
      { signal },
    )
    return () => off.abort()
  }, [studio])
}
