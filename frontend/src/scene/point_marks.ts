/** Points of a program in the picture: balls that are seen through everything, the selected one larger. */
import {
  Color,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  type Object3D,
  SphereGeometry,
  Vector3,
} from 'three'
import type { Pose } from './description'

export interface PointMark {
  readonly name: string
  readonly pose: Pose
  readonly selected: boolean
}

/** Radii [m]. */
const RADIUS = 0.015
const SELECTED = 0.025

export class PointMarks {
  readonly #mesh: InstancedMesh<SphereGeometry, MeshBasicMaterial>
  #marks: readonly PointMark[] = []
  #plain = new Color()
  #accent = new Color()

  constructor(private readonly parent: Object3D) {
    const material = new MeshBasicMaterial({ depthTest: false, transparent: true, opacity: 0.9 })
    this.#mesh = new InstancedMesh(new SphereGeometry(1, 20, 12), material, 0)
    this.#mesh.frustumCulled = false
    this.#mesh.renderOrder = 8
    this.#mesh.visible = false
    parent.add(this.#mesh)
  }

  /** Those in the picture, with their places in W [m]. */
  get shown(): readonly (PointMark & { readonly point: Vector3 })[] {
    return this.#marks.map(mark => ({ ...mark, point: placeOf(mark) }))
  }

  set(marks: readonly PointMark[]): void {
    this.#marks = marks
    this.#draw()
  }

  /** Colours of points, and of the selected one. */
  setColours(plain: Color, accent: Color): void {
    this.#plain = plain
    this.#accent = accent
    this.#draw()
  }

  dispose(): void {
    this.parent.remove(this.#mesh)
    this.#mesh.geometry.dispose()
    this.#mesh.material.dispose()
    this.#mesh.dispose()
  }

  #draw(): void {
    const matrices = new InstancedBufferAttribute(new Float32Array(16 * this.#marks.length), 16)
    const colours = new InstancedBufferAttribute(new Float32Array(3 * this.#marks.length), 3)
    this.#marks.forEach((mark, k) => {
      const radius = mark.selected ? SELECTED : RADIUS
      new Matrix4()
        .makeScale(radius, radius, radius)
        .setPosition(placeOf(mark))
        .toArray(matrices.array, 16 * k)
      ;(mark.selected ? this.#accent : this.#plain).toArray(colours.array, 3 * k)
    })
    this.#mesh.instanceMatrix = matrices
    this.#mesh.instanceColor = colours
    this.#mesh.count = this.#marks.length
    this.#mesh.visible = this.#marks.length > 0
  }
}

function placeOf({ pose }: PointMark): Vector3 {
  return new Vector3(pose[0], pose[1], pose[2])
}
