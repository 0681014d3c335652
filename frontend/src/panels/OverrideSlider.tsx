/** The override of a live run, 0 to 100 %: what is asked for shows at once, and the run when it has heard of it. */
import { useEffect, useRef, useState } from 'react'
import { useStudio } from '../studio/context'
import { words } from '../text/messages'
import type { LiveStatus } from '../wire/messages'

export function OverrideSlider({ live }: { readonly live: LiveStatus }) {
  const studio = useStudio()
  const told = Math.round(live.override * 100)
  const [percent, setPercent] = useState(told)
  const held = useRef(false)
  useEffect(() => {
    // While it is dragged the run is a little behind: the slider must not jump back.
    if (!held.current) setPercent(told)
  }, [told])
  const ask = (value: number) => {
    setPercent(value)
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
        onPointerDown={() => {
          held.current = true
        }}
        onPointerUp={() => {
          held.current = false
        }}
        onChange={event => ask(Number(event.target.value))}
      />
      <output>{words.signals.percent(percent)}</output>
    </label>
  )
}
