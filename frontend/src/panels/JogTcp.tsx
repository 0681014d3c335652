/** The tool centre point moved by steps, on and on while held, or to typed values, along world or tool axes. */
import { useState } from 'react'
import type { Pose, Vector3 } from '../scene/description'
import { useStudio } from '../studio/context'
import type { HeldMove } from '../studio/hold'
import { words } from '../text/messages'
import { compose, poseOf, rollPitchYaw, stepInWorld } from '../units/pose'
import type { Asked } from './asked'
import { HoldButton } from './HoldButton'
import { QuantityField } from './QuantityField'

type Frame = 'world' | 'tool'

const FRAMES: readonly Frame[] = ['world', 'tool']

/** Greatest rates of a held button [m/s, rad/s]: the reduced speed of ISO 10218, and as slow a turn. */
const FASTEST = 0.25
const FASTEST_TURN = Math.PI / 4

/** Steps that can be asked for [m, rad]. */
const STEPS = { lower: 1e-4, upper: 1, said: words.jog.steps }
const TURNS = { lower: Math.PI / 1800, upper: Math.PI / 2, said: words.jog.turns }

export function JogTcp({ disabled, asked }: { disabled: boolean; asked: Asked }) {
  const { jog, loop } = useStudio()
  const [frame, setFrame] = useState<Frame>('world')
  const [step, setStep] = useState(0.01)
  const [turn, setTurn] = useState(Math.PI / 36)
  const pose = jog.answer?.tcp
  if (!pose) return null
  const numbers: readonly number[] = [pose[0], pose[1], pose[2], ...rollPitchYaw(pose)]
  const axisName = (axis: number) => words.jog.axes[axis] ?? ''
  const go = (target: Pose) => {
    jog.moveTcp(target)
    loop.mark()
  }
  const held = (axis: number, sign: 1 | -1): HeldMove => {
    asked.forget()
    return {
      step: axis < 3 ? step : turn,
      fastest: axis < 3 ? FASTEST : FASTEST_TURN,
      busy: () => jog.busy,
      move: amount => {
        const { answer } = jog
        if (!answer) return false
        const by = [0, 0, 0, 0, 0, 0]
        by[axis] = sign * amount
        const [x = 0, y = 0, z = 0, roll = 0, pitch = 0, yaw = 0] = by
        const change = poseOf([x, y, z], [roll, pitch, yaw])
        const from = answer.tcp
        // What the last movement was refused is refused again; a first one may lead back.
        if (jog.moving && !answer.reached) return false
        go(frame === 'tool' ? compose(from, change) : stepInWorld(from, change))
        return true
      },
      end: () => jog.commit(words.jog.moveTcp(axisName(axis))),
    }
  }
  const type = (axis: number, value: number) => {
    const [x = 0, y = 0, z = 0, roll = 0, pitch = 0, yaw = 0] = numbers.map((one, at) =>
      at === axis ? value : one,
    )
    const position: Vector3 = [x, y, z]
    asked.set(axisName(axis), value)
    go(poseOf(position, [roll, pitch, yaw]))
    jog.commit(words.jog.typed)
  }
  return (
    <section>
      <h2>{words.jog.tcp}</h2>
      {numbers.map((value, axis) => (
        <div className="jog-row tcp" key={axisName(axis)}>
          <span className="name">{axisName(axis)}</span>
          <HoldButton
            sign="−"
            label={words.jog.minus(axisName(axis))}
            title={words.jog.hold}
            disabled={disabled}
            start={() => held(axis, -1)}
          />
          <HoldButton
            sign="+"
            label={words.jog.plus(axisName(axis))}
            title={words.jog.hold}
            disabled={disabled}
            start={() => held(axis, 1)}
          />
          <QuantityField
            label={words.jog.value(axisName(axis))}
            value={value}
            dimension={axis < 3 ? 'length' : 'angle'}
            disabled={disabled}
            refused={asked.name === axisName(axis) && jog.answer?.reached === false ? asked.why : ''}
            onWrong={asked.giveUp}
            onValue={typed => type(axis, typed)}
          />
        </div>
      ))}
      <div className="toolbar">
        <label className="inline">
          {words.jog.frame}
          <select
            value={frame}
            onChange={event => setFrame(event.target.value === 'tool' ? 'tool' : 'world')}
          >
            {FRAMES.map(one => (
              <option key={one} value={one}>
                {words.jog.frames[one]}
              </option>
            ))}
          </select>
        </label>
        <span className="inline">
          {words.jog.step}
          <QuantityField
            label={words.jog.step}
            value={step}
            dimension="length"
            range={STEPS}
            onValue={setStep}
          />
        </span>
        <span className="inline">
          {words.jog.turn}
          <QuantityField
            label={words.jog.turn}
            value={turn}
            dimension="angle"
            range={TURNS}
            onValue={setTurn}
          />
        </span>
      </div>
    </section>
  )
}
