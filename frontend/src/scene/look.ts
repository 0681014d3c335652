/** What a body looks like, ready for drawing: few geometries however many shapes it has. Equal bodies share one. */
import { Box3, type BufferGeometry, Matrix4, Quaternion, Vector3 } from 'three'
import type { LineShape, Pose, Shape } from './description'
import { LineParts, SurfaceParts } from './geometry_parts'
import type { Role } from './materials'
import type { MeshData } from './mesh_data'
import { outlineOf } from './outline'
import { box } from './prism'
import { solidOf } from './solids'

/** One draw call of a body. */
export interface Piece {
  readonly role: Role
  readonly geometry: BufferGeometry
  readonly opacity: number
  readonly open: boolean
}

/** Edge of the box that stands for a missing mesh [m]. */
const STAND_IN = 0.12

/** Pose as a matrix; the quaternion comes w first. */
export function matrixOf([x, y, z, qw, qx, qy, qz]: Pose, out = new Matrix4()): Matrix4 {
  return out.compose(new Vector3(x, y, z), new Quaternion(qx, qy, qz, qw), new Vector3(1, 1, 1))
}

export class Look {
  readonly pieces: readonly Piece[]
  /** Box about everything, in the frame of the body. */
  readonly box: Box3
  /** Points of its form that reach farthest, in the frame of the body. */
  readonly outline: readonly Vector3[]

  /** `meshes` has those that are there; the others get a hatched box when they are `missing`, or come later. */
  constructor(shapes: readonly Shape[], meshes: ReadonlyMap<string, MeshData>, missing: ReadonlySet<string>) {
    const surfaces = new Map<string, { parts: SurfaceParts; opacity: number; open: boolean }>()
    const surface = (opacity: number, open: boolean) => {
      const key = `${opacity} ${open}`
      const made = surfaces.get(key) ?? { parts: new SurfaceParts(), opacity, open }
      surfaces.set(key, made)
      return made.parts
    }
    const [creases, contours, lines] = [new LineParts(), new LineParts(), new LineParts()]
    let standIn: SurfaceParts | undefined
    for (const shape of shapes) {
      const place = matrixOf(shape.pose)
      if (shape.kind === 'line') {
        lines.add(segmentsOf(shape), place, shape.colour)
      } else if (shape.kind === 'mesh') {
        const mesh = meshes.get(shape.mesh)
        if (mesh) {
          surface(shape.opacity, true).add(mesh, place, shape.colour, shape.material, mesh.colours)
          creases.add(mesh.creases, place, shape.colour)
        } else if (shape.mesh === '' || missing.has(shape.mesh)) {
          standIn ??= new SurfaceParts()
          const solid = box([STAND_IN, STAND_IN, STAND_IN])
          standIn.add(solid, place, shape.colour, shape.material)
          creases.add(solid.creases, place, shape.colour)
        }
      } else {
        const solid = solidOf(shape)
        surface(shape.opacity, solid.open).add(solid, place, shape.colour, shape.material)
        creases.add(solid.creases, place, shape.colour)
        contours.add(solid.contours, place, shape.colour)
      }
    }
    const pieces: Piece[] = []
    const add = (role: Role, geometry: BufferGeometry | undefined, opacity = 1, open = false) => {
      if (geometry) pieces.push({ role, geometry, opacity, open })
    }
    for (const { parts, opacity, open } of surfaces.values()) {
      const geometry = parts.build()
      add('depth', geometry, opacity, open)
      add('surface', geometry, opacity, open)
    }
    add('missing', standIn?.build())
    add('crease', creases.build())
    add('contour', contours.build())
    add('line', lines.build())
    this.pieces = pieces
    this.box = new Box3()
    for (const { geometry } of pieces) this.box.union(geometry.boundingBox ?? new Box3())
    this.outline = outlineOf(pieces.map(({ geometry }) => geometry))
  }

  /** Surfaces that a line of sight can hit. */
  *surfaces(): Generator<BufferGeometry> {
    for (const piece of this.pieces)
      if (piece.role === 'surface' || piece.role === 'missing') yield piece.geometry
  }

  dispose(): void {
    for (const { geometry } of this.pieces) geometry.dispose()
  }
}

function segmentsOf({ points }: LineShape): number[] {
  return points.slice(1).flatMap((point, k) => [...(points[k] ?? point), ...point])
}
