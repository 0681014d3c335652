/** The override of a live run, 0 to 100 %: what is asked for shows at once, and the run when it has heard of it. */
import { useStudio } from '../studio/context'
import { words } from '../text/messages'
import type { LiveStatus } from '../wire/messages'
import { useAsked } from './use_asked'

export function OverrideSlider({ live }: { readonly live: LiveStatus }) {
  const studio = useStudio()
  const [percent, ask] = useAsked(Math.round(live.override * 100), value =>
    studio.send({ type: 'live_override', value: value / 100 }),
  )
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
