import { expect, test } from 'vitest'
import type { Run, Series } from '../run/run'
import { pointsOf, tracesOf, unitsOf } from './traces'

const channel = { description: '', group: '', min: [], max: [] }
const smooth: Series = { times: Float64Array.of(0, 1, 2), values: Float64Array.of(0, 1, 4), held: false }
const steps: Series = { times: Float64Array.of(0, 0.5), values: Float64Array.of(0, 1), held: true }
const run = {
  duration: 2,
  channels: [
    { ...channel, name: 'q', unit: 'rad', columns: ['1', '2'] },
    { ...channel, name: 'q_ref', unit: 'rad', columns: ['1'] },
    { ...channel, name: 'signal.ready', unit: '', columns: [''] },
  ],
  series: (name: string) => (name === 'signal.ready' ? steps : smooth),
} as unknown as Run
const columns = [
  { channel: 'q', column: 1 },
  { channel: 'q_ref', column: 0 },
  { channel: 'signal.ready', column: 0 },
]

test('traces are named after channel and column, without columns that the run lacks', () => {
  const all = [...columns, { channel: 'q', column: 5 }, { channel: 'tau', column: 0 }]
  expect(tracesOf(run, all).map(one => one.name)).toEqual([
    'Joint 2 position',
    'Joint 1 commanded position',
    'ready',
  ])
})

test('traces of one unit share a scale', () => {
  expect(unitsOf(tracesOf(run, columns))).toEqual(['°', '1'])
})

test('a column that holds its values is a trace of steps, in another run it may be smooth', () => {
  expect(tracesOf(run, columns).map(one => one.held)).toEqual([false, false, true])
})

test('a value that holds is drawn to the end of the run', () => {
  const [, , ready] = tracesOf(run, columns)
  if (!ready) throw new Error('the run has this signal')
  const { times, values } = pointsOf(run, ready, [0, 2], 100)
  expect([...times]).toEqual([0, 0.5, 2])
  expect([...values]).toEqual([0, 1, 1])
})
