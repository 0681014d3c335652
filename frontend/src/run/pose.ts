/** Poses as seven numbers in flat arrays: x, y, z, then the unit quaternion w, x, y, z. */
import type { Pose } from '../scene/description'

export const POSE = 7

/** Write a pose to place `to` of `poses`. */
export function put(poses: Float32Array, to: number, pose: Pose): void {
  poses.set(pose, to * POSE)
}

/** Write the pose of place `parent` times `pose` to place `to`. */
export function ride(poses: Float32Array, to: number, parent: number, pose: Pose): void {
  const p = parent * POSE
  const w = poses[p + 3] ?? 1
  const x = poses[p + 4] ?? 0
  const y = poses[p + 5] ?? 0
  const z = poses[p + 6] ?? 0
  const [px, py, pz, ow, ox, oy, oz] = pose
  // v + 2 w (u × v) + 2 u × (u × v) with u = (x, y, z)
  const cx = 2 * (y * pz - z * py)
  const cy = 2 * (z * px - x * pz)
  const cz = 2 * (x * py - y * px)
  const t = to * POSE
  poses[t] = (poses[p] ?? 0) + px + w * cx + y * cz - z * cy
  poses[t + 1] = (poses[p + 1] ?? 0) + py + w * cy + z * cx - x * cz
  poses[t + 2] = (poses[p + 2] ?? 0) + pz + w * cz + x * cy - y * cx
  poses[t + 3] = w * ow - x * ox - y * oy - z * oz
  poses[t + 4] = w * ox + x * ow + y * oz - z * oy
  poses[t + 5] = w * oy - x * oz + y * ow + z * ox
  poses[t + 6] = w * oz + x * oy - y * ox + z * ow
}

/**
 * Write the pose between two poses of `from` to place `to`: positions linear, orientations linear and made
 * unit again, the short way round. Neighbouring samples are so near that the angle's error does not show.
 */
export function between(
  poses: Float32Array,
  to: number,
  from: ArrayLike<number>,
  first: number,
  second: number,
  share: number,
): void {
  const t = to * POSE
  let dot = 0
  for (let k = 3; k < POSE; k++) dot += (from[first + k] ?? 0) * (from[second + k] ?? 0)
  const sign = dot < 0 ? -1 : 1
  let square = 0
  for (let k = 0; k < POSE; k++) {
    const a = from[first + k] ?? 0
    const b = (from[second + k] ?? 0) * (k < 3 ? 1 : sign)
    const value = a + (b - a) * share
    poses[t + k] = value
    if (k >= 3) square += value * value
  }
  const scale = square > 0 ? 1 / Math.sqrt(square) : 1
  for (let k = 3; k < POSE; k++) poses[t + k] = (poses[t + k] ?? 0) * scale
}
