/** The bodies of a cell before anything has moved. */
import { Matrix4, Quaternion, Vector3 } from 'three'
import type { SceneDescription } from './description'
import { matrixOf } from './look'

/** World poses, seven numbers each, and visibility at the start of a run. */
export function initialState({ bodies }: SceneDescription): { poses: Float32Array; visible: Uint8Array } {
  const poses = new Float32Array(7 * bodies.length)
  const world: Matrix4[] = []
  const [position, quaternion, scale] = [new Vector3(), new Quaternion(), new Vector3()]
  bodies.forEach(({ pose, parent }, i) => {
    const matrix = (world[parent] ?? new Matrix4()).clone().multiply(matrixOf(pose))
    world.push(matrix)
    matrix.decompose(position, quaternion, scale)
    poses.set([...position, quaternion.w, quaternion.x, quaternion.y, quaternion.z], 7 * i)
  })
  return { poses, visible: Uint8Array.from(bodies, ({ visible }) => (visible ? 1 : 0)) }
}
