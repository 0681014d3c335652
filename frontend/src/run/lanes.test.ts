import { describe, expect, it } from 'vitest'
import { barAt, heldBars, lanesOf, shownLanes } from './lanes'
import { marksOf } from './marks'
import type { Run, RunEvent, Series } from './run'

const span = { source: 'main.task', line: 4, column: 1, end_line: 4, end_column: 9 }

function event(
  time: number,
  duration: number,
  kind: string,
  data: RunEvent['data'] = {},
  station = 'robot',
): RunEvent {
  return { time, duration, kind, text: kind, station, span: kind === 'task' ? null : span, data }
}

function series(times: readonly number[], values: readonly number[]): Series {
  return { times: Float64Array.from(times), values: Float64Array.from(values), held: true }
}

function runWith(events: readonly RunEvent[], held: Readonly<Record<string, Series>> = {}): Run {
  const channels = Object.keys(held).map(name => ({
    name,
    group: name.startsWith('signal.') ? 'signals' : 'program',
    subject: name.startsWith('signal.') ? '' : 'robot',
  }))
  return {
    stations: [{ name: 'robot', program: 'main', source: 'main.task' }],
    events,
    findings: [],
    duration: 10,
    channels,
    series: (name: string) => held[name],
  } as unknown as Run
}

function lanes(run: Run) {
  return lanesOf(run, marksOf(run))
}

describe('lanes of the timeline', () => {
  it('are one for each task, called tasks below their callers', () => {
    const made = lanes(
      runWith([
        event(1, 2, 'task', { name: 'Grip', depth: 2 }),
        event(0, 4, 'task', { name: 'Pick', depth: 1 }),
        event(4, 3, 'task', { name: 'Place', depth: 1 }),
        event(7, 1, 'task', { name: 'Pick', depth: 1 }),
      ]),
    )
    expect(made.map(one => [one.name, one.depth, one.bars.length])).toEqual([
      ['Pick', 0, 2],
      ['Grip', 1, 1],
      ['Place', 0, 1],
    ])
  })

  it('tell moves, other steps and waits apart', () => {
    const kinds = ['move', 'grip', 'wait', 'await', 'output']
    const made = lanes(runWith(kinds.map((kind, at) => event(at, 0.5, kind))))
    expect(made[0]?.bars.map(bar => bar.tone)).toEqual(['move', 'act', 'wait', 'wait', 'act'])
  })

  it('are those of each station, with its own steps and its own part in the gripper', () => {
    const closed = { ...series([0, 2], [0, 1]) }
    const run = {
      stations: ['left', 'right'].map(name => ({ name, program: name, source: `${name}.task` })),
      events: [
        event(0, 1, 'move', {}, 'left'),
        event(1, 1, 'grip', { part: 'post' }, 'left'),
        event(1.5, 0.5, 'grip', { part: 'box' }, 'right'),
        event(0, 4, 'task', { name: 'Pick', depth: 1 }, 'right'),
      ],
      findings: [],
      duration: 4,
      channels: ['left', 'right'].map(name => ({ name: `${name}/gripper`, group: 'program', subject: name })),
      series: () => closed,
    } as unknown as Run
    expect(lanes(run).map(one => [one.station, one.name, one.bars.map(bar => bar.text)])).toEqual([
      ['left', 'left: Steps', ['line 4 · move', 'line 4 · grip']],
      ['right', 'right: Pick', ['Pick']],
      ['right', 'right: Steps', ['line 4 · grip']],
      ['left', 'left: Gripper', ['post']],
      ['right', 'right: Gripper', ['box']],
    ])
    expect(shownLanes(lanes(run), 'few')).toHaveLength(5)
  })

  it('leave out what the run does not have', () => {
    expect(lanes(runWith([event(0, 1, 'move')])).map(one => one.kind)).toEqual(['steps'])
    expect(lanes(runWith([]))).toEqual([])
  })

  it('are few until all are asked for', () => {
    const names = ['A', 'B', 'C', 'D', 'E']
    const made = lanes(runWith(names.map((name, at) => event(at, 1, 'task', { name, depth: 1 }))))
    expect(shownLanes(made, 'few').map(one => one.name)).toEqual(['A', 'B', 'C'])
    expect(shownLanes(made, 'all').map(one => one.name)).toEqual(names)
  })

  it('say what the gripper holds', () => {
    const grip = event(2, 0.2, 'grip', { part: 'box_1' })
    const made = lanes(runWith([grip], { gripper: series([0, 2.2, 5], [0, 1, 0]) }))
    expect(made.at(-1)?.bars).toEqual([{ from: 2.2, to: 5, text: 'box_1', tone: 'held' }])
  })

  it('know in a live run what the gripper holds, though it is seen closed a frame later', () => {
    const events = [event(2, 0.2, 'grip', { part: 'box_1' }), event(5, 0.1, 'release')]
    const made = lanes(runWith(events, { gripper: series([0, 2.21, 5.11, 7], [0, 1, 0, 1]) }))
    expect(made.at(-1)?.bars.map(bar => bar.text)).toEqual(['box_1', 'closed'])
  })

  it('of a live run show what goes on: lines since the last event of the station', () => {
    const lines = series([0, 1, 2.01, 4], [3, 4, 5, 6])
    const run = { ...runWith([event(0, 1, 'move'), event(1, 1, 'move')], { line: lines }), live: true } as Run
    expect(lanes(run)[0]?.bars.map(bar => [bar.from, bar.to, bar.tone, bar.text])).toEqual([
      [0, 1, 'move', 'line 4 · move'],
      [1, 2, 'move', 'line 4 · move'],
      [2, 2.01, 'move', 'line 4 · goes on'],
      [2.01, 4, 'move', 'line 5 · goes on'],
      [4, 10, 'move', 'line 6 · goes on'],
    ])
  })

  it('show the override in percent, and at 0 that the run is held', () => {
    const override = series([0, 1, 2, 3], [1, 0.55, 0, 1])
    const made = lanes(runWith([], { override }))
    expect(made.map(one => [one.name, one.bars.map(bar => `${bar.from} ${bar.text} ${bar.tone}`)])).toEqual([
      ['Override', ['0 100 % held', '1 55 % slowed', '2 held slowed', '3 100 % held']],
    ])
    expect(lanes(runWith([], { override: series([0, 1], [1, 1]) }))).toEqual([])
  })

  it('name signals as the cell does', () => {
    const made = lanes(runWith([], { 'signal.box_ready': series([0, 1], [0, 1]) }))
    expect(made.map(one => one.name)).toEqual(['box_ready'])
    expect(made[0]?.bars.map(bar => [bar.from, bar.to])).toEqual([[1, 10]])
  })
})

describe('held values', () => {
  it('of a switch are the stretches in which it is on', () => {
    const bars = heldBars(series([0, 1, 2, 3, 4], [0, 1, 1, 0, 1]), 6)
    expect(bars.map(bar => [bar.from, bar.to])).toEqual([
      [1, 3],
      [4, 6],
    ])
  })

  it('of numbers are all stretches, each with its number', () => {
    const bars = heldBars(series([0, 2, 3], [0, 12.5, Number.NaN]), 6)
    expect(bars.map(bar => [bar.from, bar.to, bar.text])).toEqual([
      [0, 2, '0'],
      [2, 3, '12.5'],
    ])
  })

  it('are found by time', () => {
    const bars = heldBars(series([0, 1, 3], [0, 1, 0]), 6)
    expect(barAt(bars, 2)?.from).toBe(1)
    expect(barAt(bars, 4)).toBeUndefined()
  })
})
