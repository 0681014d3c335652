/** A second arm in one transparent colour: links and tool, the base excluded. Also the mark of a selected body. */
import {
  type Color,
  DoubleSide,
  LineBasicMaterial,
  type Material,
  Matrix4,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type Object3D,
} from 'three'
import type { Bodies } from './bodies'
import { Figure, type Wardrobe } from './figure'
import type { Role } from './materials'

/** Dresses every piece alike. */
export class Tint implements Wardrobe {
  readonly #depth = new MeshBasicMaterial({ colorWrite: false, transparent: true, side: DoubleSide })
  readonly #surface: MeshLambertMaterial
  readonly #edge: LineBasicMaterial

  constructor(
    opacity: number,
    private readonly layer: number,
  ) {
    this.#surface = new MeshLambertMaterial({
      transparent: true,
      opacity,
      side: DoubleSide,
      depthWrite: false,
    })
    this.#edge = new LineBasicMaterial({
      transparent: true,
      opacity: Math.min(1, 0.5 + opacity),
      depthWrite: false,
    })
  }

  set colour(colour: Color) {
    this.#surface.color = colour
    this.#surface.emissive = colour.clone().multiplyScalar(0.25)
    this.#edge.color = colour
  }

  of(role: Role): Material | null {
    if (role === 'depth') return this.#depth
    if (role === 'surface' || role === 'missing') return this.#surface
    return role === 'crease' ? this.#edge : null
  }

  /** Depth of the whole figure comes first: only its outermost surface is seen. */
  order(role: Role): number {
    return this.layer + (role === 'depth' ? 0 : role === 'crease' ? 0.2 : 0.1)
  }

  dispose(): void {
    for (const material of [this.#depth, this.#surface, this.#edge]) material.dispose()
  }
}

export class TintedArm {
  #figures: { readonly figure: Figure; readonly body: number; readonly matrix: Matrix4 }[] = []

  constructor(
    private readonly parent: Object3D,
    private readonly bodies: Bodies,
    readonly tint: Tint,
  ) {}

  /** Take the forms of links and tools anew; the arm is hidden until it is shown again. */
  refresh(): void {
    for (const { figure } of this.#figures) figure.removeFrom(this.parent)
    this.#figures = this.bodies.list.flatMap(({ kind }, body) => {
      const look = this.bodies.look(body)
      if (!look || (kind !== 'link' && kind !== 'tool')) return []
      const matrix = new Matrix4()
      const figure = Figure.at(look, matrix)
      figure.dress(this.tint)
      figure.group.visible = false
      this.parent.add(figure.group)
      return [{ figure, body, matrix }]
    })
  }

  /** Seven numbers for every body of the scene; null hides the arm. */
  show(poses: Float32Array | null): void {
    const long = poses !== null && poses.length >= 7 * this.bodies.list.length
    for (const { figure, body, matrix } of this.#figures) {
      figure.group.visible = long && this.bodies.shown(body)
      if (long) this.bodies.read(poses, body, matrix)
    }
  }
}
