import { beforeAll, describe, expect, it } from 'vitest'
import type { SceneDescription } from '../scene/description'
import fixture from './fixtures/first_cell.json'
import { openPack } from './pack_file'
import { RecordedRun } from './recorded_run'

/** Rounding of a pack: half a step is less. */
const COORDINATE = 1e-6
/** Between samples a pack is linear: far below a pixel, above its rounding [m]. */
const BETWEEN = 3e-4

const scene = fixture.scene as unknown as SceneDescription
const file = Uint8Array.from(atob(fixture.pack), c => c.charCodeAt(0)).buffer
const poses = new Float32Array(7 * scene.bodies.length)
const visible = new Uint8Array(scene.bodies.length)
const place = (name: string) => scene.bodies.findIndex(body => body.name === name)
const pose = (name: string) => [...poses.subarray(7 * place(name), 7 * place(name) + 7)]
const distance = (a: readonly number[], b: readonly number[]) =>
  Math.hypot(...[0, 1, 2].map(k => (a[k] ?? 0) - (b[k] ?? 0)))

let run: RecordedRun
beforeAll(async () => {
  run = await RecordedRun.decode(file, scene)
})

describe('a run read from its pack', () => {
  it('has the length and the channels of the recording', () => {
    expect(run.duration).toBe(fixture.duration)
    expect(run.channels.find(one => one.name === 'q')?.columns).toHaveLength(6)
    expect(run.channels.find(one => one.name === 'tau')).toBeUndefined() // a kinematic run knows no torque
  })

  it('gives the recorded coordinates at any time', () => {
    for (const { time, q } of fixture.expected) {
      const worst = Math.max(...q.map((value, joint) => Math.abs(run.value('q', joint, time) - value)))
      expect(worst).toBeLessThan(5e-4)
    }
    const start = fixture.expected[0]?.q ?? []
    expect(start.every((value, j) => Math.abs(run.value('q', j, 0) - value) < COORDINATE)).toBe(true)
  })

  it('holds the line until the next one begins', () => {
    for (const { time, line } of fixture.expected) expect(run.value('line', 0, time)).toBe(line)
    expect(run.series('line', 0)?.held).toBe(true)
    const move = run.events.find(event => event.kind === 'move' && event.time > 0)
    expect(run.value('line', 0, move?.time ?? 0)).toBe(move?.span?.line)
  })

  it('puts the last link where forward kinematics has it', () => {
    for (const { time, last_link } of fixture.expected) {
      run.bodies(time, poses, visible)
      expect(distance(pose('link6'), last_link)).toBeLessThan(BETWEEN)
      const turn = [3, 4, 5, 6].reduce((sum, k) => sum + (pose('link6')[k] ?? 0) * (last_link[k] ?? 0), 0)
      expect(Math.abs(turn)).toBeGreaterThan(1 - 1e-6)
    }
  })

  it('keeps orientations unit', () => {
    for (let time = 0; time <= run.duration; time += 0.0371) {
      run.bodies(time, poses, visible)
      for (let body = 0; body < visible.length; body++) {
        expect(Math.hypot(...poses.subarray(7 * body + 3, 7 * body + 7))).toBeCloseTo(1, 5)
      }
    }
  })

  it.each(['grip', 'release'])('lets no part jump when the gripper acts: %s', kind => {
    const event = run.events.find(one => one.kind === kind)
    const at = (event?.time ?? 0) + (event?.duration ?? 0)
    run.bodies(at - 1e-6, poses, visible)
    const before = pose('box')
    run.bodies(at, poses, visible)
    expect(distance(pose('box'), before)).toBeLessThan(1e-4)
  })

  it('carries the box along, and leaves it where it was put', () => {
    run.bodies(0, poses, visible)
    const start = pose('box')
    run.bodies(run.duration, poses, visible)
    expect(distance(pose('box'), start)).toBeGreaterThan(0.1)
    const released = run.events.find(event => event.kind === 'release')
    const end = pose('box')
    run.bodies((released?.time ?? 0) + (released?.duration ?? 0), poses, visible)
    expect(distance(pose('box'), end)).toBe(0)
  })

  it('clamps times outside of the run', () => {
    expect(run.value('q', 0, -1)).toBe(run.value('q', 0, 0))
    expect(run.value('q', 0, 1e9)).toBe(run.value('q', 0, run.duration))
    expect(run.value('q', 9, 0)).toBeNaN()
    expect(run.value('nothing', 0, 0)).toBeNaN()
  })

  it('draws the trail in the world frame', () => {
    const { times, points } = run.trail('attained', 'robot')
    expect(points).toHaveLength(3 * times.length)
    const tcp = scene.frames.find(frame => frame.kind === 'tcp')
    run.bodies(0, poses, visible)
    const reach = Math.hypot(...(tcp?.pose.slice(0, 3) ?? []))
    expect(distance(pose('link6'), [...points.subarray(0, 3)])).toBeCloseTo(reach, 4)
  })

  it('moves the bodies of a changed scene by their names', () => {
    const [first, ...rest] = scene.bodies
    const table = {
      ...(first as SceneDescription['bodies'][number]),
      name: 'new table',
      kind: 'object' as const,
    }
    const bodies = [table, first as SceneDescription['bodies'][number], ...rest].map(body => ({
      ...body,
      parent: body.parent < 0 ? -1 : body.parent + 1,
    }))
    const many = new Float32Array(7 * bodies.length)
    run.bodies(1.25, poses, visible)
    const link = pose('link6')
    const box = pose('box')
    run.showIn({ ...scene, bodies })
    run.bodies(1.25, many, new Uint8Array(bodies.length))
    const moved = (name: string) => {
      const at = 7 * bodies.findIndex(body => body.name === name)
      return [...many.subarray(at, at + 7)]
    }
    expect(moved('link6')).toEqual(link)
    expect(moved('box')).toEqual(box)
    run.showIn(scene)
  })
})

describe('a damaged pack', () => {
  it('is refused in words', async () => {
    await expect(RecordedRun.decode(new ArrayBuffer(0), scene)).rejects.toThrow('cannot be unpacked')
    await expect(RecordedRun.decode(file.slice(0, 2000), scene)).rejects.toThrow('cannot be unpacked')
    const other = await new Response(
      new Blob(['something else']).stream().pipeThrough(new CompressionStream('gzip')),
    ).arrayBuffer()
    await expect(RecordedRun.decode(other, scene)).rejects.toThrow('does not begin with RPK1')
  })
})

describe('the result of a run', () => {
  it('has the figures of the run and says what they leave open', () => {
    const result = run.result
    expect(result?.verdict.kind).toBe('good')
    expect(result?.unchecked).toMatch(/^not checked: collisions, rated payload, torques, drives, servo/)
    expect(result?.cycle_time).toBeCloseTo(Math.max(...run.events.map(one => one.time + one.duration)), 9)
    expect(result?.moves).toBe(run.events.filter(one => one.kind === 'move').length)
    expect(result?.peak_torque).toBeNull() // a kinematic run knows no torque
  })

  it('names joint, side and time of the least margin to a limit', () => {
    const closest = run.result?.closest_limit
    const joint = run.channels.find(one => one.name === 'q')?.columns.indexOf(closest?.joint ?? '') ?? -1
    const axis = run.facts.stations[0]?.axes[joint]
    const limit = (closest?.side === 'lower' ? axis?.lower : axis?.upper) ?? Number.NaN
    const there = run.value('q', joint, closest?.time ?? 0)
    expect(Math.abs(Math.abs(limit - there) - (closest?.margin ?? 0))).toBeLessThan(5e-4)
  })
})

describe('a pack of another version', () => {
  it('is refused with its number', async () => {
    const { header, body } = await openPack(file)
    const older = RecordedRun.decode(await packOf({ ...header, version: 1 }, body), scene)
    await expect(older).rejects.toThrow('version 1; this page knows 3')
  })
})

/** Put a pack together again. */
async function packOf(header: object, body: Uint8Array): Promise<ArrayBuffer> {
  const text = new TextEncoder().encode(JSON.stringify(header))
  const length = new Uint8Array(4)
  new DataView(length.buffer).setUint32(0, text.length, true)
  const whole = new Blob(['RPK1', length, text, body.slice()])
  return await new Response(whole.stream().pipeThrough(new CompressionStream('gzip'))).arrayBuffer()
}
