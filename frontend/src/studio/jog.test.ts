import { expect, test } from 'vitest'
import type { JointDescription } from '../scene/description'
import type { Command } from '../wire/commands'
import type { Jogged } from '../wire/messages'
import { Jog } from './jog'
import { UndoStack } from './undo'

const JOINT: JointDescription = { name: '1', type: 'revolute', lower: -3, upper: 3, maxSpeed: 1 }

function bench() {
  const sent: Command[] = []
  const shown: (Jogged | null)[] = []
  const undo = new UndoStack()
  const jog = new Jog({ send: command => sent.push(command) > 0, show: answer => shown.push(answer), undo })
  jog.robot([JOINT, JOINT], 'jaws')
  const answer = (q?: readonly number[]) => {
    const last = sent.at(-1)
    if (last?.type !== 'jog_joints' && last?.type !== 'jog_tcp') return
    jog.receive({
      type: 'jogged',
      id: last.id,
      q: q ?? last.q,
      tcp: [0, 0, 0, 1, 0, 0, 0],
      bodies: [],
      reached: true,
      words: [],
    })
  }
  return { jog, sent, shown, undo, answer }
}

test('one request is out at a time and the newest of the others follows', () => {
  const { jog, sent, answer } = bench()
  jog.start([0, 0])
  for (const value of [0.1, 0.2, 0.3]) jog.moveJoint(0, value)
  expect(sent).toHaveLength(1)
  answer()
  expect(sent).toHaveLength(2)
  expect(sent[1]).toMatchObject({ type: 'jog_joints', q: [0.3, 0] })
  expect(jog.q).toEqual([0.3, 0])
})

test('a gesture is one step that can be undone', () => {
  const { jog, undo, answer } = bench()
  jog.start([0, 0])
  answer()
  jog.moveJoint(0, 0.1)
  answer()
  jog.moveJoint(0, 0.2)
  answer()
  jog.commit('Jog joint 1')
  expect(undo.names).toEqual(['Jog joint 1'])
  undo.undo()
  expect(jog.q).toEqual([0, 0])
  undo.redo()
  expect(jog.q).toEqual([0.2, 0])
})

test('a TCP target is undone to where the arm stood, though its answer comes later', () => {
  const { jog, undo, answer } = bench()
  jog.start([0, 0])
  answer()
  jog.moveTcp([1, 0, 0, 1, 0, 0, 0])
  jog.commit('Jog TCP X')
  expect(undo.names).toEqual([])
  answer([0.7, 0.1])
  expect(undo.names).toEqual(['Jog TCP X'])
  undo.undo()
  expect(jog.q).toEqual([0, 0])
})

test('a target that cannot be reached is no step', () => {
  const { jog, undo, answer } = bench()
  jog.start([0, 0])
  answer()
  jog.moveTcp([9, 0, 0, 1, 0, 0, 0])
  jog.commit('Jog TCP X')
  answer([0, 0])
  expect(undo.names).toEqual([])
})

test('stopping takes the arm away, and a late answer does not bring it back', () => {
  const { jog, shown, answer } = bench()
  jog.start([0, 0])
  jog.stop()
  answer()
  expect(shown).toEqual([null])
  expect(jog.q).toBeNull()
})

test('after a lost connection it asks anew', () => {
  const { jog, sent } = bench()
  jog.start([0.5, 0])
  jog.reconnected()
  expect(sent).toHaveLength(2)
  expect(sent[1]).toMatchObject({ q: [0.5, 0] })
})

test('it starts only with as many finite numbers as the robot has joints', () => {
  const { jog, sent } = bench()
  jog.start([0])
  jog.start([0, Number.NaN])
  expect(sent).toHaveLength(0)
})

test('a step of another robot cannot be undone onto this one', () => {
  const { jog, undo, answer } = bench()
  jog.start([0, 0])
  answer()
  jog.moveJoint(0, 0.1)
  answer()
  jog.commit('Jog joint 1')
  jog.robot([], '')
  undo.undo()
  expect(jog.q).toBeNull()
})
