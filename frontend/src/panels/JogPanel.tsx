/** The robot moved by hand through its real kinematics, and what limits and reach have to say. */
import { useState } from 'react'
import { useStudio, useStudioState } from '../studio/context'
import type { HeldMove } from '../studio/hold'
import { useChanges, useTicks } from '../studio/hooks'
import { words } from '../text/messages'
import { jointName } from '../units/names'
import { formatQuantity } from '../units/quantity'
import type { Asked } from './asked'
import { HoldButton } from './HoldButton'
import { JogTcp } from './JogTcp'
import { QuantityField } from './QuantityField'
import { Scroll } from './Scroll'
import { WritePose } from './WritePose'

/** Greatest rates of a held button [rad/s, m/s]. */
const FASTEST = { rad: Math.PI / 6, m: 0.25 } as const
/** Steps of a pressed button [rad, m]. */
const STEP = { rad: Math.PI / 180, m: 0.001 } as const
/** A joint that is this near to the typed value has it [rad | m]. */
const TAKEN = 1e-6

export function JogPanel() {
  const studio = useStudio()
  const { jog } = studio
  const scene = useStudioState(state => state.scene)
  const lost = useStudioState(state => state.connection !== 'connected')
  // The default follows the program that is open.
  useStudioState(state => state.document)
  const [typed, setTyped] = useState({ name: '', value: 0 })
  const [station, setStation] = useState('')
  useTicks(15)
  // A gesture may end when nothing moves any more: its way back is there all the same.
  useChanges(studio.undo)
  if (!scene) return <p className="empty">{words.jog.waiting}</p>
  if (!jog.q) {
    const chosen = scene.stations.some(one => one.name === station) ? station : studio.stationInSight()
    return (
      <div className="jog-start">
        <p>{words.jog.startLong}</p>
        <StationSelect chosen={chosen} onChoose={setStation} />
        <button type="button" className="primary" disabled={lost} onClick={() => studio.jogFromRun(chosen)}>
          {words.jog.start}
        </button>
        {lost ? <p className="quiet">{words.jog.lost}</p> : null}
      </div>
    )
  }
  const said = jog.answer?.words[0]?.text ?? words.jog.refused
  const asked: Asked = {
    ...typed,
    why: jog.busy ? '' : said,
    set: (name, value) => setTyped({ name, value }),
    forget: () => setTyped({ name: '', value: 0 }),
    giveUp: () => {
      setTyped({ name: '', value: 0 })
      jog.settle()
    },
  }
  return (
    <>
      <div className="toolbar">
        <button type="button" onClick={() => jog.stop()}>
          {words.jog.back}
        </button>
        <button
          type="button"
          title={words.jog.restartTitle}
          disabled={lost}
          onClick={() => studio.jogFromRun()}
        >
          {words.jog.restart}
        </button>
        <StationSelect
          chosen={jog.station}
          onChoose={name => {
            setStation(name)
            studio.jogFromRun(name)
          }}
        />
        <WritePose lost={lost} />
        <button type="button" disabled={!studio.undo.next} onClick={() => studio.undo.undo()}>
          {words.undo(studio.undo.next)}
        </button>
      </div>
      <Scroll label={words.jog.region} className="jog">
        <JogWords lost={lost} />
        <div className="jog-sides">
          <section>
            <h2>{words.jog.joints}</h2>
            {jog.joints.map((joint, at) => (
              <JointRow key={`${jog.station} ${joint.name}`} index={at} asked={asked} disabled={lost} />
            ))}
          </section>
          <JogTcp disabled={lost} asked={asked} />
        </div>
        <p className="quiet">{words.jog.run}</p>
      </Scroll>
    </>
  )
}

/** Whose robot is moved; nothing where the cell has one station. */
function StationSelect({ chosen, onChoose }: { chosen: string; onChoose: (station: string) => void }) {
  const stations = useStudioState(state => state.scene?.stations)
  if (!stations || stations.length < 2) return null
  return (
    <label className="inline">
      {words.jog.station}
      <select value={chosen} onChange={event => onChoose(event.target.value)}>
        {stations.map(({ name }) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
    </label>
  )
}

function JogWords({ lost }: { lost: boolean }) {
  const { jog } = useStudio()
  const found = jog.answer?.words ?? []
  return (
    <ul className="jog-words" aria-live="polite">
      {lost ? <li className="warning">{words.jog.lost}</li> : null}
      {found.map(one => (
        <li key={one.text} className={one.level}>
          <strong>{words.jog.levels[one.level]}</strong> {one.text}
        </li>
      ))}
      {found.length === 0 && jog.answer && !lost ? <li className="good">{words.jog.ok}</li> : null}
    </ul>
  )
}

function JointRow({ index, asked, disabled }: { index: number; asked: Asked; disabled: boolean }) {
  const { jog, loop } = useStudio()
  const joint = jog.joints[index]
  const value = jog.q?.[index]
  if (!joint || value === undefined) return null
  const unit = joint.type === 'revolute' ? 'rad' : 'm'
  const name = jointName(joint.name)
  const commit = () => jog.commit(words.jog.moveJoint(name))
  const held = (sign: 1 | -1): HeldMove => {
    asked.forget()
    return {
      step: STEP[unit],
      fastest: FASTEST[unit],
      busy: () => jog.busy,
      move: amount => {
        const from = jog.q?.[index]
        if (from === undefined) return false
        const to = Math.min(Math.max(from + sign * amount, joint.lower), joint.upper)
        if (to === from) return false
        jog.moveJoint(index, to)
        loop.mark()
        return true
      },
      end: commit,
    }
  }
  const low = formatQuantity(joint.lower, unit)
  const high = formatQuantity(joint.upper, unit)
  return (
    <div className="jog-row">
      <span className="name">{name}</span>
      <input
        type="range"
        aria-label={name}
        aria-valuetext={formatQuantity(value, unit)}
        title={words.jog.range(low, high)}
        min={joint.lower}
        max={joint.upper}
        step={unit === 'rad' ? 0.001 : 0.0001}
        value={value}
        onChange={event => {
          asked.forget()
          jog.moveJoint(index, Number(event.target.value))
          loop.mark()
        }}
        onPointerUp={commit}
        onKeyUp={commit}
      />
      {([-1, 1] as const).map(sign => (
        <HoldButton
          key={sign}
          sign={sign < 0 ? '−' : '+'}
          label={sign < 0 ? words.jog.minus(name) : words.jog.plus(name)}
          title={words.jog.hold}
          disabled={disabled}
          start={() => held(sign)}
        />
      ))}
      <QuantityField
        label={words.jog.value(name)}
        refused={asked.name === name && Math.abs(asked.value - value) > TAKEN ? asked.why : ''}
        value={value}
        dimension={unit === 'rad' ? 'angle' : 'length'}
        range={{ lower: joint.lower, upper: joint.upper, said: words.jog.outside(name, low, high) }}
        onWrong={asked.giveUp}
        onValue={typed => {
          asked.set(name, typed)
          jog.moveJoint(index, typed)
          commit()
        }}
      />
    </div>
  )
}
