/** The speed of a live run, in simulated seconds per second. */
import { SPEEDS } from '../run/cursor'
import { useStudio } from '../studio/context'
import { words } from '../text/messages'
import type { LiveStatus } from '../wire/messages'
import { useAsked } from './use_asked'

export function SpeedChoice({ live }: { readonly live: LiveStatus }) {
  const studio = useStudio()
  const [speed, ask] = useAsked(live.speed, value => studio.send({ type: 'live_speed', speed: value }))
  return (
    <label className="inline">
      {words.signals.speed}
      <select value={speed} onChange={event => ask(Number(event.target.value))}>
        {[...new Set([...SPEEDS, speed])].map(one => (
          <option key={one} value={one}>
            {one}×
          </option>
        ))}
      </select>
    </label>
  )
}
