/** The tool centre point moved by steps or to typed values, along the world's or the tool's axes. */
import { useState } from 'react'
import type { Pose, Vector3 } from '../scene/description'
import { useStudio } from '../studio/context'
import { words } from '../text/messages'
import { compose, poseOf, rollPitchYaw, stepInWorld } from '../units/pose'
import { QuantityField } from './QuantityField'

type Frame = 'world' | 'tool'

const FRAMES: readonly Frame[] = ['world', 'tool']

export function JogTcp({ disabled }: { disabled: boolean }) {
  const { jog, loop } = useStudio()
  const [frame, setFrame] = useState<Frame>('world')
  const [step, setStep] = useState(0.01)
  const [turn, setTurn] = useState(Math.PI / 36)
  const pose = jog.answer?.tcp
  if (!pose) return null
  const numbers: readonly number[] = [pose[0], pose[1], pose[2], ...rollPitchYaw(pose)]
  const axisName = (axis: number) => words.jog.axes[axis] ?? ''
  const move = (target: Pose, name: string) => {
    jog.moveTcp(target)
    jog.commit(name)
    loop.mark()
  }
  const nudge = (axis: number, sign: 1 | -1) => {
    const by = [0, 0, 0, 0, 0, 0]
    by[axis] = sign * (axis < 3 ? step : turn)
    const [x = 0, y = 0, z = 0, roll = 0, pitch = 0, yaw = 0] = by
    const change = poseOf([x, y, z], [roll, pitch, yaw])
    move(
      frame === 'tool' ? compose(pose, change) : stepInWorld(pose, change),
      words.jog.moveTcp(axisName(axis)),
    )
  }
  const type = (axis: number, value: number) => {
    const [x = 0, y = 0, z = 0, roll = 0, pitch = 0, yaw = 0] = numbers.map((one, at) =>
      at === axis ? value : one,
    )
    const position: Vector3 = [x, y, z]
    move(poseOf(position, [roll, pitch, yaw]), words.jog.typed)
  }
  return (
    <>
      <h2>{words.jog.tcp}</h2>
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
          <QuantityField label={words.jog.step} value={step} dimension="length" onValue={setStep} />
        </span>
        <span className="inline">
          {words.jog.turn}
          <QuantityField label={words.jog.turn} value={turn} dimension="angle" onValue={setTurn} />
        </span>
      </div>
      {numbers.map((value, axis) => (
        <div className="jog-row tcp" key={axisName(axis)}>
          <span className="name">{axisName(axis)}</span>
          <button
            type="button"
            disabled={disabled}
            aria-label={words.jog.minus(axisName(axis))}
            onClick={() => nudge(axis, -1)}
          >
            −
          </button>
          <button
            type="button"
            disabled={disabled}
            aria-label={words.jog.plus(axisName(axis))}
            onClick={() => nudge(axis, 1)}
          >
            +
          </button>
          <QuantityField
            label={words.jog.value(axisName(axis))}
            value={value}
            dimension={axis < 3 ? 'length' : 'angle'}
            disabled={disabled}
            onValue={typed => type(axis, typed)}
          />
        </div>
      ))}
    </>
  )
}
