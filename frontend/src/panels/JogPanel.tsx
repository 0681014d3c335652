/** The robot moved by hand through its real kinematics, and what limits and reach have to say. */
import { useStudio, useStudioState } from '../studio/context'
import { useTicks } from '../studio/hooks'
import { words } from '../text/messages'
import { formatQuantity } from '../units/quantity'
import { JogTcp } from './JogTcp'
import { QuantityField } from './QuantityField'
import { Scroll } from './Scroll'

export function JogPanel() {
  const studio = useStudio()
  const { jog } = studio
  const scene = useStudioState(state => state.scene)
  const lost = useStudioState(state => state.connection !== 'connected')
  useTicks(15)
  if (!scene) return <p className="empty">{words.jog.waiting}</p>
  if (!jog.q) {
    return (
      <div className="jog-start">
        <p>{words.jog.startLong}</p>
        <button type="button" className="primary" disabled={lost} onClick={() => studio.jogFromRun()}>
          {words.jog.start}
        </button>
        {lost ? <p className="quiet">{words.jog.lost}</p> : null}
      </div>
    )
  }
  return (
    <>
      <div className="toolbar">
        <button type="button" onClick={() => jog.stop()}>
          {words.jog.back}
        </button>
        <button type="button" disabled={lost} onClick={() => studio.jogFromRun()}>
          {words.jog.restart}
        </button>
        <button type="button" disabled={!studio.undo.next} onClick={() => studio.undo.undo()}>
          {words.undo(studio.undo.next)}
        </button>
      </div>
      <Scroll label={words.jog.region} className="jog">
        <JogWords lost={lost} />
        <h2>{words.jog.joints}</h2>
        {scene.robot.joints.map((joint, at) => (
          <JointRow key={joint.name} index={at} />
        ))}
        <JogTcp disabled={lost} />
        <p className="quiet">{words.jog.run}</p>
      </Scroll>
    </>
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

function JointRow({ index }: { index: number }) {
  const { jog, loop } = useStudio()
  const joint = jog.joints[index]
  const value = jog.q?.[index]
  if (!joint || value === undefined) return null
  const unit = joint.type === 'revolute' ? 'rad' : 'm'
  const name = /^\d+$/.test(joint.name) ? `J${joint.name}` : joint.name
  const commit = () => jog.commit(words.jog.moveJoint(name))
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
          jog.moveJoint(index, Number(event.target.value))
          loop.mark()
        }}
        onPointerUp={commit}
        onKeyUp={commit}
      />
      <QuantityField
        label={words.jog.value(name)}
        value={value}
        dimension={unit === 'rad' ? 'angle' : 'length'}
        onValue={typed => {
          jog.moveJoint(index, typed)
          commit()
        }}
      />
    </div>
  )
}
