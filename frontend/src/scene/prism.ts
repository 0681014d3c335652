/** Straight prisms over a polygon, boxes among them; rounded outlines get smooth walls. */
import { ShapeUtils, Vector2 } from 'three'
import type { Vector3 } from './description'
import { emptySolid, SMOOTH_ANGLE, type Solid } from './solid'

type Outline = readonly (readonly [number, number])[]

/** Of the walls' smooth joints a wire drawing shows one in so many. */
const CONTOUR_STEP = 6

/** A simple polygon in x, y, drawn out along +z from z = 0. */
export function prism(outline: Outline, length: number): Solid {
  const points = counterClockwise(outline)
  const solid = emptySolid(false)
  addCap(solid, points, 0, -1)
  addCap(solid, points, length, 1)
  const count = points.length
  const normals = points.map((point, k) => wallNormal(point, points[(k + 1) % count] ?? point))
  points.forEach((from, k) => {
    const to = points[(k + 1) % count] ?? from
    const own = normals[k] ?? [0, 0]
    const start = blend(normals[(k + count - 1) % count] ?? own, own)
    const end = blend(normals[(k + 1) % count] ?? own, own)
    addWall(solid, from, to, length, start ?? own, end ?? own)
    solid.creases.push(from[0], from[1], 0, to[0], to[1], 0, from[0], from[1], length, to[0], to[1], length)
    if (!start) solid.creases.push(from[0], from[1], 0, from[0], from[1], length)
    else if (k % CONTOUR_STEP === 0) solid.contours.push(from[0], from[1], 0, from[0], from[1], length)
  })
  return solid
}

/** Edges along x, y, z; centred. */
export function box([x, y, z]: Vector3): Solid {
  const [a, b] = [x / 2, y / 2]
  const solid = prism(
    [
      [-a, -b],
      [a, -b],
      [a, b],
      [-a, b],
    ],
    z,
  )
  for (const points of [solid.positions, solid.creases]) {
    for (let k = 2; k < points.length; k += 3) points[k] = (points[k] ?? 0) - z / 2
  }
  return solid
}

/** Without repeated points, counter-clockwise. */
function counterClockwise(outline: Outline): Outline {
  const points = outline.filter((point, k) => {
    const next = outline[(k + 1) % outline.length] ?? point
    return Math.hypot(next[0] - point[0], next[1] - point[1]) > 1e-9
  })
  const area = points.reduce((sum, [x, y], k) => {
    const [u, v] = points[(k + 1) % points.length] ?? [x, y]
    return sum + x * v - u * y
  }, 0)
  return area < 0 ? [...points].reverse() : points
}

function wallNormal(from: readonly [number, number], to: readonly [number, number]): [number, number] {
  const [x, y] = [to[0] - from[0], to[1] - from[1]]
  const length = Math.hypot(x, y)
  return [y / length, -x / length]
}

/** Common normal of two walls that meet smoothly, undefined at a corner. */
function blend(a: readonly number[], b: readonly number[]): [number, number] | undefined {
  const [ax = 0, ay = 0] = a
  const [bx = 0, by = 0] = b
  if (ax * bx + ay * by <= Math.cos(SMOOTH_ANGLE)) return undefined
  const length = Math.hypot(ax + bx, ay + by)
  return [(ax + bx) / length, (ay + by) / length]
}

function addWall(
  solid: Solid,
  from: readonly [number, number],
  to: readonly [number, number],
  length: number,
  start: readonly [number, number],
  end: readonly [number, number],
): void {
  const i = solid.positions.length / 3
  solid.positions.push(from[0], from[1], 0, to[0], to[1], 0, to[0], to[1], length, from[0], from[1], length)
  solid.normals.push(start[0], start[1], 0, end[0], end[1], 0, end[0], end[1], 0, start[0], start[1], 0)
  solid.indices.push(i, i + 1, i + 2, i, i + 2, i + 3)
}

function addCap(solid: Solid, points: Outline, z: number, side: 1 | -1): void {
  const start = solid.positions.length / 3
  for (const [x, y] of points) {
    solid.positions.push(x, y, z)
    solid.normals.push(0, 0, side)
  }
  const faces = ShapeUtils.triangulateShape(
    points.map(([x, y]) => new Vector2(x, y)),
    [],
  )
  for (const [a = 0, b = 0, c = 0] of faces) {
    solid.indices.push(start + a, start + (side > 0 ? b : c), start + (side > 0 ? c : b))
  }
}
