/** Coordinate systems as crosses of arrows: x red, y green, z blue. All of them are one draw call. */
import {
  type BufferGeometry,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  type Object3D,
  Quaternion,
  Vector3,
} from 'three'
import type { Bodies } from './bodies'
import type { FrameMark } from './description'
import { SurfaceParts } from './geometry_parts'
import { matrixOf } from './look'
import { revolve } from './revolve'
import type { FrameKind } from './settings'

export const AXIS_COLOURS = ['#e0413c', '#3a9e46', '#3b74e8'] as const

/** Length of the arrows [m]. */
const LENGTHS: Record<FrameKind, number> = { world: 0.25, base: 0.2, frame: 0.16, location: 0.06, tcp: 0.11 }

export interface Cross {
  readonly mark: FrameMark
  readonly matrix: Matrix4
  readonly local: Matrix4
}

export class Crosses {
  readonly #mesh: InstancedMesh<BufferGeometry, MeshBasicMaterial>
  #all: Cross[] = []
  #shown: readonly Cross[] = []
  #kinds: ReadonlySet<FrameKind> = new Set(['world', 'base', 'frame', 'tcp'])

  constructor(
    private readonly parent: Object3D,
    private readonly bodies: Bodies,
  ) {
    this.#mesh = new InstancedMesh(arrows(), new MeshBasicMaterial({ vertexColors: true }), 0)
    this.#mesh.frustumCulled = false
    parent.add(this.#mesh)
  }

  /** Those in the picture, with their poses. */
  get shown(): readonly Cross[] {
    return this.#shown
  }

  load(marks: readonly FrameMark[]): void {
    this.#all = marks.map(mark => {
      const scale = LENGTHS[mark.kind]
      const local = matrixOf(mark.pose).scale(new Vector3(scale, scale, scale))
      return { mark, local, matrix: local.clone() }
    })
    this.#mesh.instanceMatrix = new InstancedBufferAttribute(new Float32Array(16 * marks.length), 16)
    this.#choose()
  }

  setKinds(kinds: ReadonlySet<FrameKind>): void {
    this.#kinds = kinds
    this.#choose()
  }

  /** Follow the bodies that carry them. */
  update(): void {
    this.#shown.forEach(({ mark, local, matrix }, k) => {
      const carrier = this.bodies.matrix(mark.parent)
      if (carrier) matrix.multiplyMatrices(carrier, local)
      matrix.toArray(this.#mesh.instanceMatrix.array, 16 * k)
    })
    this.#mesh.count = this.#shown.length
    this.#mesh.visible = this.#shown.length > 0
    this.#mesh.instanceMatrix.needsUpdate = true
  }

  dispose(): void {
    this.parent.remove(this.#mesh)
    this.#mesh.geometry.dispose()
    this.#mesh.material.dispose()
    this.#mesh.dispose()
  }

  #choose(): void {
    this.#shown = this.#all.filter(({ mark }) => this.#kinds.has(mark.kind))
    this.update()
  }
}

/** Three arrows of length 1 and a small ball where they meet. */
function arrows(): BufferGeometry {
  const parts = new SurfaceParts()
  const arrow = revolve([
    [0, 0],
    [0.017, 0],
    [0.017, 0.8],
    [0.05, 0.8],
    [0, 1],
  ])
  const z = new Vector3(0, 0, 1)
  const unit = new Vector3(1, 1, 1)
  AXIS_COLOURS.forEach((colour, k) => {
    const turn = new Quaternion().setFromUnitVectors(z, new Vector3().setComponent(k, 1))
    parts.add(arrow, new Matrix4().compose(new Vector3(), turn, unit), colour, 'paint')
  })
  return parts.build()
}
