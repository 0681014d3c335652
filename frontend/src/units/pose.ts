/** Poses as the page needs them: products, and roll, pitch, yaw about the fixed axes x, y, z. */
import type { Pose, Vector3 } from '../scene/description'

type Quaternion = readonly [number, number, number, number]

function times(a: Quaternion, b: Quaternion): Quaternion {
  const [aw, ax, ay, az] = a
  const [bw, bx, by, bz] = b
  return [
    aw * bw - ax * bx - ay * by - az * bz,
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
  ]
}

function turn(q: Quaternion, [x, y, z]: Vector3): Vector3 {
  const [w, a, b, c] = q
  const [, px, py, pz] = times(times(q, [0, x, y, z]), [w, -a, -b, -c])
  return [px, py, pz]
}

/** X_AC of X_AB and X_BC. */
export function compose(outer: Pose, inner: Pose): Pose {
  const q: Quaternion = [outer[3], outer[4], outer[5], outer[6]]
  const [x, y, z] = turn(q, [inner[0], inner[1], inner[2]])
  const [w, a, b, c] = times(q, [inner[3], inner[4], inner[5], inner[6]])
  return [outer[0] + x, outer[1] + y, outer[2] + z, w, a, b, c]
}

/** Pose of a position [m] and roll, pitch, yaw [rad]: R = Rz(yaw) Ry(pitch) Rx(roll). */
export function poseOf([x, y, z]: Vector3, [roll, pitch, yaw]: Vector3): Pose {
  const about = (angle: number, axis: 1 | 2 | 3): Quaternion => {
    const q: [number, number, number, number] = [Math.cos(angle / 2), 0, 0, 0]
    q[axis] = Math.sin(angle / 2)
    return q
  }
  return [x, y, z, ...times(about(yaw, 3), times(about(pitch, 2), about(roll, 1)))]
}

/** Roll, pitch, yaw [rad] of a pose; at pitch ±90° all of the turn is in the yaw. */
export function rollPitchYaw(pose: Pose): Vector3 {
  const [, , , w, x, y, z] = pose
  const sine = Math.max(-1, Math.min(1, 2 * (w * y - x * z)))
  const pitch = Math.asin(sine)
  if (Math.abs(sine) > 1 - 1e-9) return [0, pitch, -2 * Math.sign(sine) * Math.atan2(x, w)]
  return [
    Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
    pitch,
    Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
  ]
}

/** Add to a pose in W: a shift along W's axes and a turn about W's axes through its own origin. */
export function stepInWorld(pose: Pose, step: Pose): Pose {
  const [x, y, z] = pose
  const turned = times([step[3], step[4], step[5], step[6]], [pose[3], pose[4], pose[5], pose[6]])
  return [x + step[0], y + step[1], z + step[2], ...turned]
}
