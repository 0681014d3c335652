import { readFileSync } from 'node:fs'
import { afterEach, expect, test } from 'vitest'
import type { Run } from '../run/run'
import { METRIC, setUnits } from '../units/choice'
import type { PeakFigure, ResultFigures } from '../wire/result'
import { tilesOf } from './result_tiles'

const RESULT: ResultFigures = {
  verdict: { kind: 'good', text: 'everything as planned' },
  given: '',
  unchecked: 'not checked: collisions',
  cycle_time: 186.8,
  cycle_time_valid: true,
  cycle_time_by_hand: '',
  settling: { total: 18.68, share: 0.1, time: 5.7, station: 'robot', line: 10 },
  peak_torque: { share: 0.742, closeness: 'far', station: 'robot', joint: '2', line: 9, time: 3.5 },
  peak_speed: null,
  closest_limit: {
    margin: 0.0733,
    closeness: 'far',
    unit: 'rad',
    station: 'robot',
    joint: '5',
    side: 'upper',
    line: 18,
    time: 40,
  },
  path_error: { max: 0.00031, station: 'robot', line: 10, time: 1.2 },
  errors: 0,
  warnings: 0,
  hints: 0,
  moves: 217,
  destinations: null,
  contact_force: null,
}
const STATIONS = [{ name: 'robot', program: 'main', source: 'main.task' }]
const RUN = { duration: 186.8, findings: [], stations: STATIONS, channels: [] } as unknown as Run

function tile(id: string, change: Partial<ResultFigures> = {}, run: Run = RUN) {
  const found = tilesOf(run, { ...RESULT, ...change }).find(one => one.id === id)
  if (!found) throw new Error(`there is a tile ${id}`)
  return found
}

afterEach(() => setUnits(METRIC))

test('the strip shows these figures in this order', () => {
  const ids = ['cycle', 'settling', 'torque', 'limit', 'path', 'findings']
  expect(tilesOf(RUN, RESULT).map(one => one.id)).toEqual(ids)
  const unknown = { ...RESULT, peak_torque: null, closest_limit: null, path_error: null }
  expect(tilesOf(RUN, unknown).map(one => one.id)).toEqual(ids)
})

test('the guide of the studio tells them by their names', () => {
  const guide = readFileSync(new URL('../../../docs/how-to/studio.md', import.meta.url), 'utf8')
  const told = guide.split('\n\n').find(one => one.startsWith('The strip below the menus')) ?? ''
  const names = [...told.matchAll(/\*\*(.+?)\*\*/gs)].map(([, name = '']) => name.replace(/\s+/g, ' '))
  const all = { ...RESULT, destinations: { wanted: 1, reached: 1 } }
  expect(names).toEqual(tilesOf(RUN, all).map(one => one.label))
})

test('a figure names its joint and leads to its moment and line', () => {
  expect(tile('torque')).toMatchObject({ value: '74 %', detail: 'Joint 2', time: 3.5, line: 9 })
  expect(tile('limit')).toMatchObject({ value: '4.20°', detail: 'Joint 5, upper limit', time: 40, line: 18 })
  expect(tile('path')).toMatchObject({ value: '0.31 mm', detail: 'line 10', time: 1.2 })
})

test('figures are in the units of the user', () => {
  setUnits({ length: 'in', angle: 'rad' })
  expect(tile('limit').value).toBe('0.0733 rad')
  expect(tile('path').value).toBe('0.012 in')
})

test('settling is told with its share and leads to the longest wait', () => {
  expect(tile('settling')).toMatchObject({
    value: '18.68 s',
    detail: '10 % of the cycle',
    time: 5.7,
    line: 10,
  })
})

test('a cycle time without skipped moves only is a plain one', () => {
  expect(tile('cycle').tone).toBe('plain')
  expect(tile('cycle', { cycle_time_valid: false })).toMatchObject({ tone: 'error' })
})

test('a cycle time with a hold by hand says so where it stands', () => {
  const held = tile('cycle', { cycle_time_by_hand: 'held for 3.20 s by hand' })
  expect(held).toMatchObject({ detail: 'held for 3.20 s by hand', tone: 'warning' })
})

test('parts with a destination are counted where a cell has some', () => {
  expect(tile('parts', { destinations: { wanted: 3, reached: 3 } })).toMatchObject({
    value: '3 of 3',
    detail: '',
    tone: 'plain',
    time: 186.8,
  })
  const missed = tile('parts', { destinations: { wanted: 3, reached: 1 } })
  expect(missed).toMatchObject({ value: '1 of 3', detail: '2 elsewhere', tone: 'warning' })
})

test('what a run does not know is said, and leads nowhere', () => {
  expect(tile('torque', { peak_torque: null })).toMatchObject({ value: '–', time: null, line: 0 })
  expect(tile('path', { path_error: null })).toMatchObject({ value: '–', time: null })
})

test('a run without drives has no path error and no settling', () => {
  const driven = { ...RUN, channels: [{ name: 'tau' }] } as unknown as Run
  expect(tile('path', { path_error: null })).toMatchObject({ value: '–', detail: 'without drives' })
  expect(tile('path', { path_error: null }, driven)).toMatchObject({ value: '–', detail: 'no tool paths' })
  expect(tile('settling', { settling: null })).toMatchObject({
    value: '–',
    detail: 'without drives',
    time: null,
  })
})

test('a joint near the end of its range is a warning, one beyond it an error', () => {
  const margin = RESULT.closest_limit
  if (!margin) throw new Error('the result has a margin')
  const at = (closeness: PeakFigure['closeness']) =>
    tile('limit', { closest_limit: { ...margin, closeness } }).tone
  expect((['far', 'near', 'beyond'] as const).map(at)).toEqual(['plain', 'warning', 'error'])
})

test('a torque without a limit in the model is no torque that was not simulated', () => {
  const driven = { ...RUN, channels: [{ name: 'left/tau' }] } as unknown as Run
  expect(tile('torque', { peak_torque: null }).detail).toBe('not simulated')
  expect(tile('torque', { peak_torque: null }, driven).detail).toBe('limit unknown')
})

test('findings count and lead to the worst one', () => {
  const finding = (severity: string, time: number) => ({ severity, time, span: null })
  const run = { ...RUN, findings: [finding('warning', 1), finding('error', 7)] } as unknown as Run
  const found = tile('findings', { errors: 1, warnings: 1 }, run)
  expect(found).toMatchObject({ value: '2', detail: '1 error, 1 warning', tone: 'error', time: 7 })
  expect(tile('findings', { hints: 2 })).toMatchObject({ value: '2', detail: '2 hints', tone: 'plain' })
  expect(tile('findings').detail).toBe('no problems found')
})

test('a torque beyond its limit is an error, one near it a warning', () => {
  const at = (closeness: PeakFigure['closeness']) =>
    tile('torque', { peak_torque: { share: 0.9, closeness, station: 'robot', joint: '1', line: 1, time: 1 } })
      .tone
  expect((['far', 'near', 'beyond'] as const).map(at)).toEqual(['plain', 'warning', 'error'])
})

test('with several stations a figure names its own and leads to the text that this one runs', () => {
  const stations = ['left', 'right'].map(name => ({ name, program: name, source: `programs/${name}.task` }))
  const run = { ...RUN, stations } as unknown as Run
  const peak = { share: 0.5, closeness: 'far', station: 'right', joint: '4', line: 8, time: 2 } as const
  expect(tile('torque', { peak_torque: peak }, run)).toMatchObject({
    detail: 'right: Joint 4',
    source: 'programs/right.task',
    line: 8,
  })
  expect(tile('settling', {}, run)).toMatchObject({ detail: "10 % of the stations' cycles together" })
})
