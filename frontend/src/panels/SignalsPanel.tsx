/** Inputs and outputs of the cell; keys that set inputs; the live run they act in. */
import { useMemo } from 'react'
import { marksOf } from '../run/marks'
import { useStudio, useStudioState } from '../studio/context'
import { useChanges, useTicks } from '../studio/hooks'
import type { SignalBoard } from '../studio/signal_board'
import { words } from '../text/messages'
import { formatPlain, formatQuantity } from '../units/quantity'
import { InputRow } from './InputRow'
import { keyLabel } from './key_label'
import { LiveBar } from './LiveBar'
import { letGo } from './let_go'
import { Scroll } from './Scroll'

export function SignalsPanel() {
  const studio = useStudio()
  const { signals } = studio
  const scene = useStudioState(state => state.scene)
  const live = useStudioState(state => state.live !== null && state.live.state !== 'over')
  useChanges(signals)
  useTicks(10)
  const value = (name: string, initial: number) => {
    const shown = studio.run?.value(`signal.${name}`, 0, studio.cursor.time) ?? Number.NaN
    return Number.isFinite(shown) ? shown : initial
  }
  const inputs = scene?.signals.filter(one => one.input) ?? []
  const outputs = scene?.signals.filter(one => !one.input) ?? []
  return (
    <>
      <LiveBar />
      <Scroll label={words.signals.region}>
        <div className={signals.armed ? 'arming armed' : 'arming'}>
          <button
            type="button"
            role="switch"
            aria-checked={signals.armed}
            aria-label={words.signals.arm}
            disabled={inputs.length === 0}
            onClick={event => {
              if (signals.armed) signals.disarm()
              else signals.arm()
              letGo(event)
            }}
          >
            <i aria-hidden="true" />
          </button>
          <strong>{signals.armed ? words.signals.armed : words.signals.disarmed}</strong>
        </div>
        {inputs.length > 0 ? <p role="status">{nextStep(signals, live)}</p> : null}
        <h2>{words.signals.inputs}</h2>
        {inputs.length === 0 ? <p className="quiet">{words.signals.noInputs}</p> : null}
        {inputs.map(one => (
          <InputRow key={one.name} signal={one} value={value(one.name, one.initial)} />
        ))}
        <h2>{words.signals.outputs}</h2>
        {outputs.length === 0 ? <p className="quiet">{words.signals.noOutputs}</p> : null}
        <ul className="outputs">
          {outputs.map(one => (
            <li key={one.name}>
              <span>{one.name}</span> <output>{formatPlain(value(one.name, one.initial))}</output>
            </li>
          ))}
        </ul>
        <Presses />
      </Scroll>
    </>
  )
}

/** What to do now, for somebody who does it for the first time. */
function nextStep(signals: Pick<SignalBoard, 'armed' | 'bindings'>, live: boolean): string {
  const { steps, keyOf, or } = words.signals
  if (!live) return signals.armed ? steps.armedOnly : steps.start
  const keys = signals.bindings
    .filter(one => one.code)
    .map(one => keyOf(keyLabel(one.code), one.signal))
    .join(or)
  return signals.armed ? steps.press(keys) : steps.arm(keys)
}

function Presses() {
  const studio = useStudio()
  const stamped = useStudioState(state => state.presses)
  const shown = useStudioState(state => state.shown)
  const recorded = useStudioState(state => state.status?.inputs ?? 0)
  const run = shown > 0 ? studio.run : null
  const presses = useMemo(
    () =>
      run && !run.live
        ? marksOf(run).inputs
        : stamped.map(({ time, name, value }) => ({ time, text: `${name} = ${formatPlain(value)}` })),
    [run, stamped],
  )
  const count = Math.max(recorded, presses.length)
  return (
    <>
      <h2>{words.signals.presses}</h2>
      {count > 0 ? (
        <>
          <p className="quiet">{words.signals.repeated}</p>
          <div className="toolbar">
            <span>{words.status.inputs(count)}</span>
            <button type="button" onClick={() => studio.forgetPresses()}>
              {words.signals.forget}
            </button>
          </div>
        </>
      ) : (
        <p className="quiet">{words.signals.noPresses}</p>
      )}
      {presses.length > 0 ? (
        <table className="presses">
          <thead>
            <tr>
              <th scope="col">{words.signals.time}</th>
              <th scope="col">{words.signals.signal}</th>
            </tr>
          </thead>
          <tbody>
            {presses.map((one, at) => (
              // biome-ignore lint/suspicious/noArrayIndexKey: presses are only ever appended
              <tr key={at}>
                <td>{formatQuantity(one.time, 's')}</td>
                <td>{one.text}</td>
              </tr>
            ))}
          </tbody>
        </table>
      ) : null}
    </>
  )
}
