import { expect, test } from 'vitest'
import type { JointDescription, StationDescription } from '../scene/description'
import type { Command } from '../wire/commands'
import type { Jogged } from '../wire/messages'
import { Jog } from './jog'
import { UndoStack } from './undo'

const JOINT: JointDescription = { name: '1', type: 'revolute', lower: -3, upper: 3, maxSpeed: 1 }

const LEFT: StationDescription = {
  name: 'left',
  robot: 'r',
  title: 'R',
  program: 'left',
  tool: 'jaws',
  base: [0, 0, 0, 1, 0, 0, 0],
  joints: [JOINT, JOINT],
}
const RIGHT: StationDescription = { ...LEFT, name: 'right', program: 'right', tool: 'fork' }

test('what was refused is said no more once it is given up', () => {
  const { jog, sent } = bench()
  jog.start('left', [0, 0])
  const refused = {
    tcp: LEFT.base,
    bodies: [],
    words: [{ level: 'error', text: 'too far' }],
    location: '',
    typed: '',
  } as const
  jog.receive({ type: 'jogged', id: 1, q: [0, 0.5], reached: true, ...refused })
  jog.settle()
  expect(sent).toHaveLength(1) // it stands where it was to
  jog.moveTcp([9, 0, 0, 1, 0, 0, 0])
  jog.receive({ type: 'jogged', id: 2, q: [0, 0.5], reached: false, ...refused })
  jog.settle()
  expect(sent.slice(1)).toMatchObject([{ type: 'jog_tcp' }, { type: 'jog_joints', q: [0, 0.5] }])
})

function bench() {
  const sent: Command[] = []
  const shown: (Jogged | null)[] = []
  const undo = new UndoStack()
  const jog = new Jog({ send: command => sent.push(command) > 0, show: answer => shown.push(answer), undo })
  jog.setStations([LEFT, RIGHT])
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
      location: '',
      typed: '',
    })
  }
  return { jog, sent, shown, undo, answer }
}

test('one request is out at a time and the newest of the others follows', () => {
  const { jog, sent, answer } = bench()
  jog.start('left', [0, 0])
  for (const value of [0.1, 0.2, 0.3]) jog.moveJoint(0, value)
  expect(sent).toHaveLength(1)
  answer()
  expect(sent).toHaveLength(2)
  expect(sent[1]).toMatchObject({ type: 'jog_joints', q: [0.3, 0] })
  expect(jog.q).toEqual([0.3, 0])
})

test('a gesture is one step that can be undone', () => {
  const { jog, undo, answer } = bench()
  jog.start('left', [0, 0])
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
  jog.start('left', [0, 0])
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
  jog.start('left', [0, 0])
  answer()
  jog.moveTcp([9, 0, 0, 1, 0, 0, 0])
  jog.commit('Jog TCP X')
  answer([0, 0])
  expect(undo.names).toEqual([])
})

test('stopping takes the arm away, and a late answer does not bring it back', () => {
  const { jog, shown, answer } = bench()
  jog.start('left', [0, 0])
  jog.stop()
  answer()
  expect(shown).toEqual([null])
  expect(jog.q).toBeNull()
})

test('after a lost connection it asks anew', () => {
  const { jog, sent } = bench()
  jog.start('left', [0.5, 0])
  jog.reconnected()
  expect(sent).toHaveLength(2)
  expect(sent[1]).toMatchObject({ q: [0.5, 0] })
})

test('it starts only with as many finite numbers as the robot has joints', () => {
  const { jog, sent } = bench()
  jog.start('left', [0])
  jog.start('left', [0, Number.NaN])
  expect(sent).toHaveLength(0)
})

test('a step of another robot cannot be undone onto this one', () => {
  const { jog, undo, answer } = bench()
  jog.start('left', [0, 0])
  answer()
  jog.moveJoint(0, 0.1)
  answer()
  jog.commit('Jog joint 1')
  jog.setStations([{ ...LEFT, joints: [] }])
  undo.undo()
  expect(jog.q).toBeNull()
})

test('another station is asked for with its own tool and does not hear what the first one was answered', () => {
  const { jog, sent, answer } = bench()
  jog.start('left', [0.1, 0.2])
  const late = sent.length
  jog.start('right', [0.3, 0.4])
  expect(sent).toHaveLength(late + 1)
  expect(sent.at(-1)).toMatchObject({ type: 'jog_joints', station: 'right', q: [0.3, 0.4], tool: 'fork' })
  jog.receive({
    type: 'jogged',
    id: 1,
    q: [0.1, 0.2],
    tcp: [0, 0, 0, 1, 0, 0, 0],
    bodies: [],
    reached: true,
    words: [],
    location: '',
    typed: '',
  })
  expect(jog.answer).toBeNull()
  answer()
  expect(jog.answer?.q).toEqual([0.3, 0.4])
  expect(jog.station).toBe('right')
})

test('a step of one station is undone at that station, whichever is jogged meanwhile', () => {
  const { jog, sent, undo, answer } = bench()
  jog.start('left', [0, 0])
  answer()
  jog.moveJoint(0, 0.1)
  answer()
  jog.commit('Jog joint 1')
  jog.start('right', [0.3, 0.4])
  answer()
  undo.undo()
  expect(sent.at(-1)).toMatchObject({ station: 'left', q: [0, 0] })
})
