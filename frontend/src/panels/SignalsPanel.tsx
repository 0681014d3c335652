/** Inputs and outputs of the cell; keys that set inputs; the live run they act in. */
import { useStudio, useStudioState } from '../studio/context'
import { useChanges, useTicks } from '../studio/hooks'
import { words } from '../text/messages'
import { formatPlain, formatQuantity } from '../units/quantity'
import { InputRow } from './InputRow'
import { LiveBar } from './LiveBar'
import { Scroll } from './Scroll'

export function SignalsPanel() {
  const studio = useStudio()
  const { signals } = studio
  const scene = useStudioState(state => state.scene)
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
            onClick={() => (signals.armed ? signals.disarm() : signals.arm())}
          >
            <i aria-hidden="true" />
          </button>
          <strong>{signals.armed ? words.signals.armed : words.signals.disarmed}</strong>
        </div>
        <p className="quiet">{words.signals.onlyLive}</p>
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

function Presses() {
  const studio = useStudio()
  const presses = useStudioState(state => state.presses)
  const recorded = useStudioState(state => state.status?.inputs ?? 0)
  return (
    <>
      <h2>{words.signals.presses}</h2>
      {recorded || presses.length ? (
        <div className="toolbar">
          <span>{words.status.inputs(Math.max(recorded, presses.length))}</span>
          <button type="button" onClick={() => studio.forgetPresses()}>
            {words.signals.forget}
          </button>
        </div>
      ) : (
        <p className="quiet">{words.signals.noPresses}</p>
      )}
      {presses.length ? (
        <table className="presses">
          <thead>
            <tr>
              <th scope="col">{words.signals.time}</th>
              <th scope="col">{words.signals.signal}</th>
              <th scope="col">{words.signals.value}</th>
            </tr>
          </thead>
          <tbody>
            {presses.map((one, at) => (
              // biome-ignore lint/suspicious/noArrayIndexKey: presses are only ever appended
              <tr key={at}>
                <td>{formatQuantity(one.time, 's')}</td>
                <td>{one.name}</td>
                <td>{formatPlain(one.value)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      ) : null}
    </>
  )
}
