/** Triangles of a GLB file as plain numbers. */
import { EdgesGeometry, Mesh, MeshStandardMaterial, type Object3D, Vector3 } from 'three'

export interface MeshData {
  readonly positions: number[]
  readonly normals: number[]
  readonly indices: number[]
  /** Three linear values per corner where the file has colours of its own. */
  readonly colours?: number[]
  readonly creases: number[]
}

/** Edges are only sought in meshes of up to so many triangles: the search takes time. */
const EDGES_UP_TO = 40_000

/** Faces that turn by more than this meet in an edge [deg]. */
const EDGE_ANGLE = 30

/** Read a GLB file. The loader comes only when the first mesh is read. */
export async function readMesh(bytes: ArrayBuffer): Promise<MeshData> {
  const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js')
  const { scene } = await new GLTFLoader().parseAsync(bytes, '')
  return meshData(scene)
}

/** All triangles below an object. Files are z up as everything here; glTF's own convention is not applied. */
export function meshData(root: Object3D): MeshData {
  const data = { positions: [], normals: [], indices: [], colours: [], creases: [] } as Required<MeshData>
  let coloured = false
  root.updateMatrixWorld(true)
  root.traverse(object => {
    if (object instanceof Mesh) coloured = append(data, object) || coloured
  })
  const { colours, ...plain } = data
  return coloured ? { ...plain, colours } : plain
}

/** Add one mesh; whether it has colours of its own. */
function append(data: Required<MeshData>, mesh: Mesh): boolean {
  const geometry = mesh.geometry.clone().applyMatrix4(mesh.matrixWorld)
  if (!geometry.getAttribute('normal')) geometry.computeVertexNormals()
  const position = geometry.getAttribute('position')
  const normal = geometry.getAttribute('normal')
  const colour = geometry.hasAttribute('color') ? geometry.getAttribute('color') : undefined
  const tint = mesh.material instanceof MeshStandardMaterial ? mesh.material.color : undefined
  const start = data.positions.length / 3
  const unit = new Vector3()
  for (let k = 0; k < position.count; k++) {
    data.positions.push(position.getX(k), position.getY(k), position.getZ(k))
    data.normals.push(...unit.fromBufferAttribute(normal, k).normalize())
    if (colour) data.colours.push(colour.getX(k), colour.getY(k), colour.getZ(k))
    else data.colours.push(tint?.r ?? 1, tint?.g ?? 1, tint?.b ?? 1)
  }
  const index = geometry.getIndex()
  const corners = index?.count ?? position.count
  for (let k = 0; k < corners; k++) data.indices.push(start + (index ? index.getX(k) : k))
  if (corners <= 3 * EDGES_UP_TO) {
    for (const value of new EdgesGeometry(geometry, EDGE_ANGLE).getAttribute('position').array) {
      data.creases.push(value)
    }
  }
  geometry.dispose()
  return colour !== undefined || (tint !== undefined && tint.getHex() !== 0xffffff)
}
