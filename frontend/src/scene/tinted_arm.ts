/** A second arm in one transparent colour: links and tool, the base excluded. Also the mark of a selected body. */
import {
  type Color,
  DoubleSide,
  LineBasicMaterial,
  type Material,
  Matrix4,
  MeshBasicMaterial,
  NotEqualStencilFunc,
  type Object3D,
} from 'three'
import type { Bodies } from './bodies'
import { Figure, type Wardrobe } from './figure'
import { ARM_MARK, type Role } from './materials'
import { TintMaterial } from './tint_material'

/** What moves with the arm. */
const MOVED: ReadonlySet<string> = new Set(['link', 'cylinder', 'tool'])

/** `beside`: nothing is drawn where the arm itself is seen; `upon`: it lies over what it marks. */
export type TintPlace = 'beside' | 'upon'

/** Dresses every piece alike. */
export class Tint implements Wardrobe {
  readonly #depth = new MeshBasicMaterial({ colorWrite: false, transparent: true, side: DoubleSide })
  readonly #surface: TintMaterial
  readonly #edge: LineBasicMaterial

  constructor(
    strength: number,
    private readonly layer: number,
    place: TintPlace,
  ) {
    this.#surface = new TintMaterial(strength)
    this.#edge = new LineBasicMaterial({
      transparent: true,
      opacity: Math.min(1, 0.45 + strength),
      depthWrite: false,
    })
    if (place === 'upon') return
    for (const material of this.#all) {
      material.setValues({ stencilWrite: true, stencilRef: ARM_MARK, stencilFunc: NotEqualStencilFunc })
    }
  }

  set colour(colour: Color) {
    this.#surface.colour = colour
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

  casts(): boolean {
    return false
  }

  dispose(): void {
    for (const material of this.#all) material.dispose()
  }

  get #all(): readonly Material[] {
    return [this.#depth, this.#surface, this.#edge]
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
      if (!look || !MOVED.has(kind)) return []
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
