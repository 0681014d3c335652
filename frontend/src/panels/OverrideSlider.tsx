/** The override of a live run, 0 to 100 %: what is asked for shows at once, and the run when it has heard of it. */
import { useEffect, useState } from 'react'
import { useStudio } from '../studio/context'
import { words } from '../text/messages'
import type { LiveStatus } from '../wire/messages'

/** After this time the slider shows again what the run says [ms]. */
const PATIENCE = 2000

export function OverrideSlider({ live }: { readonly live: LiveStatus }) {
  const studio = useStudio()
  const told = Math.round(live.override * 100)
  // The run is a little behind: until it has come to what was asked for last, the slider must not jump back.
  const [asked, setAsked] = useState<number | null>(null)
  useEffect(() => {
    if (asked === null) return
    const timer = setTimeout(() => setAsked(null), told === asked ? 0 : PATIENCE)
    return () => clearTimeout(timer)
  }, [asked, told])
  const percent = asked ?? told
  const ask = (value: number) => {
    setAsked(value)
    studio.send({ type: 'live_override', value: value / 100 })
  }
  return (
    <label className="inline" title={words.signals.overrideTitle}>
      {words.signals.override}
      <input
        type="range"
        min={0}
        max={100}
        step={1}
        value={percent}
        disabled={live.state === 'starting'}
        aria-valuetext={words.signals.percent(percent)}
        onChange={event => ask(Number(event.target.value))}
      />
      <output>{words.signals.percent(percent)}</output>
    </label>
  )
}
