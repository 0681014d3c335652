/** Start, hold, step, override, speed and end of a live run. */
import { useStudio, useStudioState } from '../studio/context'
import type { LiveOrder } from '../studio/live_orders'
import { words } from '../text/messages'
import { OverrideSlider } from './OverrideSlider'
import { SpeedChoice } from './SpeedChoice'

export function LiveBar() {
  const studio = useStudio()
  const live = useStudioState(state => state.live)
  const program = useStudioState(state => state.program)
  const programs = useStudioState(state => state.programs)
  const connected = useStudioState(state => state.connection === 'connected')
  const on = live !== null && live.state !== 'over'
  const finished = useStudioState(state => state.shown > 0 && state.status?.state === 'done')
  const inputs = useStudioState(state => state.status?.inputs ?? 0)
  const { id } = studio.runs
  const given = finished && studio.run?.result?.given
  const control = (order: LiveOrder) => studio.live.order(order)
  return (
    <div className="toolbar" role="toolbar" aria-label={words.signals.live}>
      {on ? null : (
        <>
          <button
            type="button"
            className="primary"
            disabled={!connected}
            onClick={() => studio.send({ type: 'live_start', program, speed: 1, begin: 'running' })}
          >
            {words.signals.start}
          </button>
          {programs.length > 1 ? (
            <select
              aria-label={words.panels.program}
              value={program}
              onChange={event => studio.store.setState({ program: event.target.value })}
            >
              {programs.map(one => (
                <option key={one}>{one}</option>
              ))}
            </select>
          ) : null}
        </>
      )}
      {!on && finished && connected && id > 0 ? (
        <>
          <button
            type="button"
            title={words.signals.saveRecordingTitle}
            onClick={() => studio.commands.run('export.recording')}
          >
            {words.signals.saveRecording}
          </button>
          {inputs > 0 || given ? (
            <button
              type="button"
              title={words.signals.saveInputsTitle}
              onClick={() => studio.commands.run('export.inputs')}
            >
              {words.signals.saveInputs}
            </button>
          ) : null}
        </>
      ) : null}
      {on && live ? (
        <>
          <strong className="live-mark">{words.run.live}</strong>
          {live.state === 'held' ? (
            <button type="button" onClick={() => control('continue')}>
              {words.signals.resume}
            </button>
          ) : (
            <button
              type="button"
              disabled={live.state === 'starting'}
              title={words.signals.holdTitle}
              onClick={() => control('hold')}
            >
              {words.signals.hold}
            </button>
          )}
          <button
            type="button"
            disabled={live.state !== 'held'}
            title={words.signals.stepTitle}
            onClick={() => control('step')}
          >
            {words.signals.step}
          </button>
          <button type="button" onClick={() => control('stop')}>
            {words.signals.stop}
          </button>
          <OverrideSlider live={live} />
          <SpeedChoice live={live} />
        </>
      ) : null}
    </div>
  )
}
