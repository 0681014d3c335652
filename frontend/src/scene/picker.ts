/** What a line of sight hits. */
import { Matrix4, Mesh, type Ray, Raycaster, Vector3 } from 'three'
import type { Bodies } from './bodies'

export interface Hit {
  readonly body: number
  /** In W [m]. */
  readonly point: Vector3
}

const INVERSE = new Matrix4()
const THROUGH = new Vector3()
const RAYCASTER = new Raycaster()
const PROBE = new Mesh()

/** The nearest surface of the bodies in the picture, or null. */
export function pick(bodies: Bodies, ray: Ray): Hit | null {
  let best = Number.POSITIVE_INFINITY
  let body = -1
  bodies.list.forEach((_, i) => {
    const [look, matrix] = [bodies.look(i), bodies.matrix(i)]
    if (!look || !matrix || !bodies.solid(i)) return
    RAYCASTER.ray.copy(ray).applyMatrix4(INVERSE.copy(matrix).invert())
    if (!RAYCASTER.ray.intersectBox(look.box, THROUGH)) return
    for (const geometry of look.surfaces()) {
      PROBE.geometry = geometry
      const distance = RAYCASTER.intersectObject(PROBE)[0]?.distance ?? best
      if (distance >= best) continue
      best = distance
      body = i
    }
  })
  return body < 0 ? null : { body, point: ray.at(best, new Vector3()) }
}
