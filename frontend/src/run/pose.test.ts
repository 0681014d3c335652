import { expect, test } from 'vitest'
import type { Pose } from '../scene/description'
import { compose, poseOf } from '../units/pose'
import { between, POSE, put, ride } from './pose'

/** Poses are kept as 32-bit numbers. */
const FLOAT = 1e-6

const outer = poseOf([1, -2, 0.5], [0.3, -1.1, 2.4])
const inner = poseOf([0.2, 0.1, -0.7], [-2, 0.4, 1])

function near(found: ArrayLike<number>, wanted: ArrayLike<number>): void {
  for (let k = 0; k < POSE; k++) {
    expect(Math.abs((found[k] ?? Number.NaN) - (wanted[k] ?? Number.NaN))).toBeLessThan(FLOAT)
  }
}

test('what rides has the product of the poses', () => {
  const poses = new Float32Array(2 * POSE)
  put(poses, 0, outer)
  ride(poses, 1, 0, inner)
  near(poses.subarray(POSE), compose(outer, inner))
})

test('between two poses positions are linear and orientations unit', () => {
  const poses = new Float32Array(POSE)
  const quarter: Pose = poseOf([2, 0, 0], [0, 0, Math.PI / 2])
  between(poses, 0, [...poseOf([0, 0, 0], [0, 0, 0]), ...quarter], 0, POSE, 0.5)
  near(poses, poseOf([1, 0, 0], [0, 0, Math.PI / 4]))
})

test('orientations turn the short way, whatever the signs of the quaternions', () => {
  const poses = new Float32Array(POSE)
  const [x, y, z, w, a, b, c] = poseOf([0, 0, 0], [0, 0, 0.2])
  between(poses, 0, [...poseOf([0, 0, 0], [0, 0, 0]), x, y, z, -w, -a, -b, -c], 0, POSE, 0.5)
  near(poses, poseOf([0, 0, 0], [0, 0, 0.1]))
})
