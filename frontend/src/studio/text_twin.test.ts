import { expect, test } from 'vitest'
import type { Run } from '../run/run'
import type { SceneDescription } from '../scene/description'
import { limitShare, textTwin } from './text_twin'

const SCENE = {
  bodies: [{ name: 'link1' }],
  frames: [{ name: 'tcp', kind: 'tcp', parent: 0, pose: [0.1, 0, 0, 1, 0, 0, 0] }],
  stations: [
    {
      name: 'robot',
      joints: [
        { name: '1', lower: -2, upper: 2 },
        { name: '2', lower: 0, upper: 1 },
      ],
    },
  ],
} as unknown as SceneDescription

test('it names the TCP in millimetres and the joint nearest to its limit', () => {
  const run = { value: (_: string, joint: number) => [1, 0.97][joint] } as unknown as Run
  // Turned by 90° about z: what the tool has along x points along y.
  const poses = Float32Array.of(0.3, 0.12, 0.6, Math.SQRT1_2, 0, 0, Math.SQRT1_2)
  expect(textTwin(SCENE, poses, run, 0)).toBe(
    'TCP 300.0, 220.0, 600.0 mm; Joint 2: 94 % of the way to its limit',
  )
})

test('without a run it says where the TCP is', () => {
  expect(textTwin(SCENE, Float32Array.of(0, 0, 0, 1, 0, 0, 0), null, 0)).toBe('TCP 100.0, 0.0, 0.0 mm')
})

test('while a robot is jogged it says where that stands, and not where the run shows it', () => {
  const run = { value: () => 0 } as unknown as Run
  const poses = Float32Array.of(0.3, 0.12, 0.6, 1, 0, 0, 0)
  const jogged = { station: 'robot', q: [0.5, 0.9], tcp: [0.7, 0, 0.2, 1, 0, 0, 0] } as const
  expect(textTwin(SCENE, poses, run, 0, jogged)).toBe(
    'TCP 700.0, 0.0, 200.0 mm; Joint 2: 80 % of the way to its limit',
  )
  const elsewhere = { ...jogged, station: 'other' }
  expect(textTwin(SCENE, poses, run, 0, elsewhere)).toMatch(/^TCP 400.0, 120.0, 600.0 mm/)
})

test('a joint without limits is never near one', () => {
  expect(limitShare(3, Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY)).toBe(0)
  expect(limitShare(-2, -2, 2)).toBe(1)
})

test('it tells of each station by its name', () => {
  const scene = {
    bodies: [{ name: 'left/link1' }, { name: 'right/link1' }],
    frames: ['left', 'right'].map((name, parent) => ({
      name: `${name}/tcp`,
      kind: 'tcp',
      parent,
      pose: [0, 0, 0, 1, 0, 0, 0],
    })),
    stations: ['left', 'right'].map(name => ({ name, joints: [] })),
  } as unknown as SceneDescription
  const poses = Float32Array.of(0.1, 0, 0, 1, 0, 0, 0, 0.2, 0, 0, 1, 0, 0, 0)
  expect(textTwin(scene, poses, null, 0)).toBe('left: TCP 100.0, 0.0, 0.0 mm. right: TCP 200.0, 0.0, 0.0 mm')
})
