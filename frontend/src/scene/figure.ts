/** A look in the scene: drawn once, or at many places in one go. */
import {
  Group,
  InstancedBufferAttribute,
  InstancedMesh,
  LineSegments,
  type Material,
  type Matrix4,
  Mesh,
  type Object3D,
} from 'three'
import type { Look, Piece } from './look'
import type { Role, Wearer } from './materials'
import { CASTERS } from './shadow'

/** Gives materials to the pieces of a look; null for those that are not drawn. */
export interface Wardrobe {
  of(role: Role, opacity: number, open: boolean, wearer: Wearer): Material | null
  /** Later ones are drawn over earlier ones, among the transparent. */
  order(role: Role, wearer: Wearer): number
  /** Whether it throws a shadow. */
  casts(role: Role, opacity: number): boolean
}

type Drawable = Mesh | LineSegments

export class Figure {
  readonly group = new Group()
  readonly #drawables: { readonly drawable: Drawable; readonly piece: Piece }[]

  private constructor(look: Look, make: (piece: Piece) => Drawable) {
    this.#drawables = look.pieces.map(piece => ({ piece, drawable: make(piece) }))
    for (const { drawable } of this.#drawables) this.group.add(drawable)
  }

  /** One figure that stays wherever the matrix is: they share it. */
  static at(look: Look, matrix: Matrix4): Figure {
    return new Figure(look, ({ role, geometry }) => {
      const drawable = isLines(role) ? new LineSegments(geometry) : new Mesh(geometry)
      drawable.matrixWorld = matrix
      return drawable
    })
  }

  /** As many figures as `crowd` has places. */
  static of(look: Look, crowd: Crowd): Figure {
    return new Figure(look, ({ role, geometry }) => {
      const drawable = isLines(role)
        ? new InstancedSegments(geometry)
        : new InstancedMesh(geometry, undefined, 0)
      drawable.instanceMatrix = crowd.matrices
      drawable.frustumCulled = false
      crowd.add(drawable)
      return drawable
    })
  }

  dress(wardrobe: Wardrobe, opacity = 1, wearer: Wearer = 'thing'): void {
    for (const { drawable, piece } of this.#drawables) {
      const material = wardrobe.of(piece.role, piece.opacity * opacity, piece.open, wearer)
      drawable.visible = material !== null
      if (material) drawable.material = material
      drawable.renderOrder = wardrobe.order(piece.role, wearer)
      if (wardrobe.casts(piece.role, piece.opacity * opacity)) drawable.layers.enable(CASTERS)
      else drawable.layers.disable(CASTERS)
    }
  }

  removeFrom(parent: Object3D): void {
    parent.remove(this.group)
    // Only what belongs to this figure; geometries and materials are shared.
    for (const { drawable } of this.#drawables) if (drawable instanceof InstancedMesh) drawable.dispose()
  }
}

/** Places of many equal figures. */
export class Crowd {
  readonly matrices: InstancedBufferAttribute
  readonly #drawables: { count: number }[] = []

  constructor(capacity: number) {
    this.matrices = new InstancedBufferAttribute(new Float32Array(16 * capacity), 16)
  }

  add(drawable: { count: number }): void {
    this.#drawables.push(drawable)
  }

  place(index: number, matrix: Matrix4): void {
    matrix.toArray(this.matrices.array, 16 * index)
  }

  /** The first `count` places are taken. */
  setCount(count: number): void {
    for (const drawable of this.#drawables) drawable.count = count
    this.matrices.needsUpdate = true
  }
}

/** Line segments at many places: three.js instances every object that looks like its `InstancedMesh`. */
class InstancedSegments extends LineSegments {
  readonly isInstancedMesh = true
  readonly instanceColor = null
  readonly morphTexture = null
  instanceMatrix = new InstancedBufferAttribute(new Float32Array(0), 16)
  override count = 0
}

function isLines(role: Role): boolean {
  return role === 'crease' || role === 'contour' || role === 'line'
}
