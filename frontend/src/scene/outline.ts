/** A few points that reach as far as a form does, in many directions: enough to fit it into a picture. */
import { type BufferGeometry, Vector3 } from 'three'

/** To the faces, edges and corners of a cube. */
const DIRECTIONS = [-1, 0, 1].flatMap(x =>
  [-1, 0, 1].flatMap(y => [-1, 0, 1].flatMap(z => (x || y || z ? [new Vector3(x, y, z).normalize()] : []))),
)

/** The points of geometries that lie farthest in each of 26 directions, each once. */
export function outlineOf(geometries: Iterable<BufferGeometry>): Vector3[] {
  const far = DIRECTIONS.map(() => ({ reach: Number.NEGATIVE_INFINITY, point: new Vector3() }))
  for (const geometry of new Set(geometries)) {
    const positions = geometry.getAttribute('position')
    DIRECTIONS.forEach((direction, d) => {
      const best = far[d]
      const farthest = farthestAlong(direction, positions.array)
      if (best && farthest.reach > best.reach) {
        best.reach = farthest.reach
        best.point.fromArray(positions.array, farthest.at)
      }
    })
  }
  const found = new Map<string, Vector3>()
  for (const { reach, point: one } of far) {
    if (reach > Number.NEGATIVE_INFINITY) found.set(one.toArray().join(), one)
  }
  return [...found.values()]
}

/** How far points reach in a direction, and where the numbers of the first one begin that reaches so far. */
function farthestAlong({ x, y, z }: Vector3, points: ArrayLike<number>): { reach: number; at: number } {
  let [reach, at] = [Number.NEGATIVE_INFINITY, 0]
  for (let k = 0; k < points.length; k += 3) {
    const own = x * (points[k] ?? 0) + y * (points[k + 1] ?? 0) + z * (points[k + 2] ?? 0)
    if (own <= reach) continue
    reach = own
    at = k
  }
  return { reach, at }
}
