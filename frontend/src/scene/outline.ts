/** A few points that reach as far as a form does, in many directions: enough to fit it into a picture. */
import { type BufferGeometry, Vector3 } from 'three'

/** To the faces, edges and corners of a cube. */
const DIRECTIONS = [-1, 0, 1].flatMap(x =>
  [-1, 0, 1].flatMap(y => [-1, 0, 1].flatMap(z => (x || y || z ? [new Vector3(x, y, z).normalize()] : []))),
)

/** The points of geometries that lie farthest in each of 26 directions, each once. */
export function outlineOf(geometries: Iterable<BufferGeometry>): Vector3[] {
  const far = DIRECTIONS.map(() => ({ reach: Number.NEGATIVE_INFINITY, point: new Vector3() }))
  const point = new Vector3()
  for (const geometry of geometries) {
    const positions = geometry.getAttribute('position')
    for (let k = 0; k < positions.count; k++) {
      point.fromBufferAttribute(positions, k)
      DIRECTIONS.forEach((direction, d) => {
        const best = far[d]
        const reach = direction.dot(point)
        if (!best || reach <= best.reach) return
        best.reach = reach
        best.point.copy(point)
      })
    }
  }
  const found = new Map<string, Vector3>()
  for (const { reach, point: one } of far) {
    if (reach > Number.NEGATIVE_INFINITY) found.set(one.toArray().join(), one)
  }
  return [...found.values()]
}
