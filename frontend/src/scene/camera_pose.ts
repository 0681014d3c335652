/** Where a camera stands and how gestures move it: pure functions. Up in the picture is z in the world, always. */
import { Box3, MathUtils, Vector3 } from 'three'
import type { Vector3 as Triple } from './description'
import type { CameraPose, Preset, Projection } from './settings'

/** Full vertical angle of view of the perspective cameras [rad]. */
export const FIELD_OF_VIEW = 0.6

/** Half the height that is seen at the target, per distance. Parallel projection shows the same height. */
export const HALF_HEIGHT = Math.tan(FIELD_OF_VIEW / 2)

const LEAST_ELEVATION = MathUtils.degToRad(-5)
const NEAREST = 0.02
const FARTHEST = 200

/** Share of the picture that a fitted box fills. */
const FILLED = 0.93

/** Directions of view: azimuth and elevation of the eye seen from the target [rad], and the projection. */
export const DIRECTIONS: Record<Exclude<Preset, 'custom'>, readonly [number, number, Projection]> = {
  perspective: [MathUtils.degToRad(-52), MathUtils.degToRad(24), 'perspective'],
  top: [-Math.PI / 2, Math.PI / 2, 'parallel'],
  front: [-Math.PI / 2, 0, 'parallel'],
  right: [0, 0, 'parallel'],
  isometric: [-Math.PI / 4, Math.asin(1 / Math.sqrt(3)), 'parallel'],
}

/** Axes of the picture in W: to the right, up, and towards the eye. */
export interface Basis {
  readonly right: Vector3
  readonly up: Vector3
  readonly back: Vector3
}

export function basisOf({ azimuth, elevation }: Pick<CameraPose, 'azimuth' | 'elevation'>): Basis {
  const [ca, sa] = [Math.cos(azimuth), Math.sin(azimuth)]
  const [ce, se] = [Math.cos(elevation), Math.sin(elevation)]
  return {
    right: new Vector3(-sa, ca, 0),
    up: new Vector3(-se * ca, -se * sa, ce),
    back: new Vector3(ce * ca, ce * sa, se),
  }
}

export function eyeOf(pose: CameraPose): Vector3 {
  return new Vector3(...pose.target).addScaledVector(basisOf(pose).back, pose.distance)
}

/** Turn about a point, which keeps its place in the picture. The eye never goes below `floor` [m] by turning. */
export function orbit(
  pose: CameraPose,
  pivot: Vector3,
  turn: number,
  tilt: number,
  floor: number,
): CameraPose {
  const eye = eyeOf(pose)
  const least = Math.min(LEAST_ELEVATION, pose.elevation)
  const turned = (share: number) => {
    const elevation = MathUtils.clamp(pose.elevation + share * tilt, least, Math.PI / 2)
    return turnedAbout(pose, pivot, eye, pose.azimuth + turn, elevation)
  }
  const shares = [1, 0.5, 0.25]
  return turned(shares.find(share => eyeOf(turned(share)).z >= Math.min(floor, eye.z)) ?? 0)
}

/** Look from another direction at the same target. */
export function lookFrom(pose: CameraPose, azimuth: number, elevation: number): CameraPose {
  return { ...pose, azimuth: wrapped(azimuth), elevation }
}

/** Move the picture so that what lies at `depth` [m] before the eye goes right and up by shares of its height. */
export function pan(pose: CameraPose, right: number, up: number, depth: number): CameraPose {
  const basis = basisOf(pose)
  const scale = -2 * HALF_HEIGHT * depth
  const target = new Vector3(...pose.target)
    .addScaledVector(basis.right, scale * right)
    .addScaledVector(basis.up, scale * up)
  return { ...pose, target: target.toArray() }
}

/** Come nearer to a point (factor < 1) or go away from it; it keeps its place in the picture. */
export function zoom(pose: CameraPose, point: Vector3, factor: number): CameraPose {
  const distance = MathUtils.clamp(pose.distance * factor, NEAREST, FARTHEST)
  const share = distance / pose.distance
  const eye = eyeOf(pose).sub(point).multiplyScalar(share).add(point)
  return { ...pose, target: eye.addScaledVector(basisOf(pose).back, -distance).toArray(), distance }
}

/** Depth of a point before the eye [m]. */
export function depthOf(pose: CameraPose, point: Vector3): number {
  return (
    pose.distance -
    point
      .clone()
      .sub(new Vector3(...pose.target))
      .dot(basisOf(pose).back)
  )
}

/**
 * The same direction of view, near enough that all points just fit with a margin about them. The upper `covered` share
 * of the picture stays free: buttons lie there.
 */
export function fitted(
  pose: CameraPose,
  points: readonly Vector3[],
  aspect: number,
  projection: Projection,
  covered = 0,
): CameraPose {
  const { right, up, back } = basisOf(pose)
  const centre = new Box3().setFromPoints([...points]).getCenter(new Vector3())
  const corners = points.map(point => point.clone().sub(centre))
  const near = projection === 'perspective' ? 1 : 0
  // In perspective the middle of the picture is not that of the points: both are found by turns.
  const target = new Vector3()
  let distance = NEAREST
  const arm = new Vector3()
  for (let turn = 0; turn < 6; turn++) {
    const arms = corners.map(corner => {
      arm.subVectors(corner, target)
      return { right: arm.dot(right), up: arm.dot(up), nearer: near * arm.dot(back) }
    })
    distance = NEAREST
    for (const one of arms) {
      const half = Math.max(Math.abs(one.up) / (1 - covered), Math.abs(one.right) / aspect)
      distance = Math.max(distance, half / (HALF_HEIGHT * FILLED) + one.nearer)
    }
    const middle = (along: 'right' | 'up') => {
      const places = arms.map(one => one[along] / (distance - one.nearer))
      return 0.5 * distance * (Math.min(...places) + Math.max(...places))
    }
    target.addScaledVector(right, middle('right')).addScaledVector(up, middle('up'))
  }
  target.addScaledVector(up, covered * HALF_HEIGHT * distance)
  return { ...pose, target: centre.add(target).toArray(), distance: Math.min(distance, FARTHEST) }
}

/** Between two poses, `share` 0 … 1, turning the short way. */
export function between(a: CameraPose, b: CameraPose, share: number): CameraPose {
  const mix = (from: number, to: number) => from + (to - from) * share
  const target: Triple = [
    mix(a.target[0], b.target[0]),
    mix(a.target[1], b.target[1]),
    mix(a.target[2], b.target[2]),
  ]
  return {
    target,
    azimuth: a.azimuth + wrapped(b.azimuth - a.azimuth) * share,
    elevation: mix(a.elevation, b.elevation),
    distance: a.distance * (b.distance / a.distance) ** share,
  }
}

function turnedAbout(pose: CameraPose, pivot: Vector3, eye: Vector3, azimuth: number, elevation: number) {
  const before = basisOf(pose)
  const after = basisOf({ azimuth, elevation })
  const arm = eye.clone().sub(pivot)
  const target = pivot
    .clone()
    .addScaledVector(after.right, arm.dot(before.right))
    .addScaledVector(after.up, arm.dot(before.up))
    .addScaledVector(after.back, arm.dot(before.back) - pose.distance)
  return { target: target.toArray() as Triple, azimuth: wrapped(azimuth), elevation, distance: pose.distance }
}

/** Into -π … π. */
function wrapped(angle: number): number {
  return MathUtils.euclideanModulo(angle + Math.PI, 2 * Math.PI) - Math.PI
}

/** The eight corners of a box; none of an empty one. */
export function cornersOf(box: Box3): Vector3[] {
  if (box.isEmpty()) return []
  const { min, max } = box
  return [min.x, max.x].flatMap(x =>
    [min.y, max.y].flatMap(y => [min.z, max.z].map(z => new Vector3(x, y, z))),
  )
}
