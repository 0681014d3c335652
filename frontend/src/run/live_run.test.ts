import { describe, expect, it } from 'vitest'
import type { SceneDescription } from '../scene/description'
import type { LiveLayout } from '../wire/messages'
import { FrameStore } from './frame_store'
import { LiveRun } from './live_run'

const still = [0, 0, 0, 1, 0, 0, 0] as const
const body = { kind: 'link', parent: -1, pose: still, shapes: [], visible: true } as const
const scene = {
  stations: [{ name: 'robot', base: [0, 0, 1, 1, 0, 0, 0] }],
  bodies: [
    { ...body, name: 'base' },
    { ...body, name: 'link1' },
    { ...body, name: 'tool:hand', parent: 1, pose: [0, 0, 0.5, 1, 0, 0, 0] },
    { ...body, name: 'box', visible: false },
  ],
} as unknown as SceneDescription

const channel = (name: string, column: string, held = false) => ({
  name,
  column,
  unit: '',
  description: '',
  group: '',
  subject: 'robot',
  held,
})
const layout: LiveLayout = {
  type: 'layout',
  channels: [
    channel('q', 'a'),
    channel('line', '', true),
    ...['x', 'y', 'z'].map(axis => channel('attained_position', axis)),
  ],
  bodies: [1],
  stations: [{ name: 'robot', program: 'main', source: 'main.task' }],
}

function frame(time: number, q: number, line: number, x: number) {
  return {
    sequence: 0,
    time,
    wall: 0,
    values: Float32Array.of(q, line, x, 0, 0),
    poses: Float32Array.of(x, 0, 0, 1, 0, 0, 0),
  }
}

function started(): LiveRun {
  const run = new LiveRun(scene, layout)
  run.add(frame(0, 1, 4, 0))
  run.add(frame(1, 3, 5, 2))
  return run
}

const poses = new Float32Array(28)
const visible = new Uint8Array(4)

describe('a live run', () => {
  it('is asked by time like any run', () => {
    const run = started()
    expect(run.duration).toBe(1)
    expect(run.value('q', 0, 0.5)).toBe(2)
    expect(run.value('line', 0, 0.99)).toBe(4)
    expect(run.value('q', 1, 0)).toBeNaN()
    expect(run.channels.map(one => [one.name, one.columns.length])).toEqual([
      ['q', 1],
      ['line', 1],
      ['attained_position', 3],
      ['tcp_speed', 1],
    ])
    expect(run.channels[0]).toMatchObject({ min: [1], max: [3] })
  })

  it('moves bodies of frames, and those that ride on them', () => {
    const run = started()
    run.bodies(0.5, poses, visible)
    expect([...poses.subarray(7, 10)]).toEqual([1, 0, 0])
    expect([...poses.subarray(14, 17)]).toEqual([1, 0, 0.5])
    expect([...visible]).toEqual([1, 1, 1, 0])
  })

  it('lets a part ride from its grasp on', () => {
    const run = started()
    const grasp = [0, 0, 0.25, 1, 0, 0, 0] as const
    run.place({ type: 'placed', time: 0.5, body: 3, parent: 1, pose: grasp, visible: true })
    run.bodies(0.4, poses, visible)
    expect(visible[3]).toBe(0)
    run.bodies(1, poses, visible)
    expect(visible[3]).toBe(1)
    expect([...poses.subarray(21, 24)]).toEqual([2, 0, 0.25])
  })

  it('gives the same series until it grows', () => {
    const run = started()
    const series = run.series('q', 0)
    expect(run.series('q', 0)).toBe(series)
    run.add(frame(2, 5, 5, 3))
    expect([...(run.series('q', 0)?.values ?? [])]).toEqual([1, 3, 5])
  })

  it('has its trail in the world frame', () => {
    expect([...started().trail('attained', 'robot').points]).toEqual([0, 0, 1, 2, 0, 1])
  })

  it('leaves out frames that are old or fit no layout', () => {
    const run = started()
    run.add(frame(0.5, 9, 9, 9))
    run.add({ ...frame(3, 0, 0, 0), poses: new Float32Array(0) })
    expect(run.duration).toBe(1)
  })

  it('has the speed of the TCP like a finished run, as a series and at a time', () => {
    const run = started()
    run.add(frame(2, 5, 5, 3))
    expect([...(run.series('tcp_speed', 0)?.values ?? [])]).toEqual([2, 1.5, 1])
    for (const [time, speed] of [
      [0, 2],
      [0.5, 1.75],
      [1, 1.5],
      [1.75, 1.125],
      [9, 1],
    ] as const)
      expect(run.value('tcp_speed', 0, time)).toBe(speed)
    expect(new LiveRun(scene, layout).value('tcp_speed', 0, 0)).toBeNaN()
  })

  it('takes events, and lets a task that goes on become longer', () => {
    const run = started()
    const common = { time: 0, text: '', station: 'robot', span: null }
    const task = { ...common, kind: 'task', data: { name: 'Pick', serial: 1, depth: 1 } }
    run.happen({ type: 'happened', event: { ...task, duration: 1 } })
    run.happen({ type: 'happened', event: { ...common, kind: 'move', duration: 2, data: {} } })
    run.happen({ type: 'happened', event: { ...task, duration: 3 } })
    expect(run.events.map(one => [one.kind, one.duration])).toEqual([
      ['task', 3],
      ['move', 2],
    ])
  })

  it('remembers key presses as events', () => {
    const run = started()
    run.stamp({ type: 'stamped', name: 'button', value: 1, time: 0.75 })
    expect(run.events).toEqual([expect.objectContaining({ time: 0.75, kind: 'input', text: 'button = 1' })])
  })

  it('finds its bodies by name when the cell is edited meanwhile', () => {
    const run = started()
    const grasp = [0, 0, 0.25, 1, 0, 0, 0] as const
    run.place({ type: 'placed', time: 0.5, body: 3, parent: 1, pose: grasp, visible: true })
    const [base, link, , box] = scene.bodies
    run.showIn({ ...scene, bodies: [base, box, link] } as SceneDescription)
    // The part stands before the link here, so that it cannot ride on it: it keeps the pose that it was given.
    const few = new Float32Array(21)
    run.bodies(1, few, visible)
    expect([...few.subarray(14, 17)]).toEqual([2, 0, 0])
    expect(visible[1]).toBe(1)
    run.showIn({ ...scene, bodies: [link] } as SceneDescription)
    const one = new Float32Array(7)
    run.bodies(1, one, visible)
    expect([...one]).toEqual([2, 0, 0, 1, 0, 0, 0])
  })

  it('stands as the scene describes it before its first frame', () => {
    new LiveRun(scene, layout).bodies(0, poses, visible)
    expect([...poses.subarray(7, 14)]).toEqual([...still])
  })
})

describe('the frame store', () => {
  it('forgets the oldest rows when it is full, and keeps the rest as they were', () => {
    const store = new FrameStore(1, 2000)
    const empty = new Float32Array(0)
    for (let k = 0; k < 5000; k++) store.add(k, Float32Array.of(k % 1000), empty)
    expect(store.count).toBeLessThanOrEqual(2000)
    expect(store.rows.length).toBe(2000)
    expect(store.last).toBe(4999)
    const first = 5000 - store.count
    expect(store.times()[0]).toBe(first)
    expect(store.times()).toHaveLength(store.count)
    expect(store.column(0)[store.count - 1]).toBe(999)
    expect(store.locate(4000.5)).toEqual({ index: 4000 - first, share: 0.5 })
  })
})
