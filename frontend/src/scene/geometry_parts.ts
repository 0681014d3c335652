/** Collects surfaces and lines in the frame of a body and makes one geometry of each sort out of them. */
import { BufferAttribute, BufferGeometry, Color, Matrix3, type Matrix4, Vector3 } from 'three'
import type { Material } from './description'
import { finishBytes } from './finish'
import type { Solid } from './solid'

const POINT = new Vector3()

/** Triangles of several solids with a colour at each corner. */
export class SurfaceParts {
  readonly #positions: number[] = []
  readonly #normals: number[] = []
  readonly #colours: number[] = []
  readonly #finishes: number[] = []
  readonly #indices: number[] = []

  /** `colours` has three linear values per corner; without it all get `colour`. */
  add(
    solid: Pick<Solid, 'positions' | 'normals' | 'indices'>,
    place: Matrix4,
    colour: string,
    material: Material,
    colours?: number[],
  ): void {
    const start = this.#positions.length / 3
    appendMoved(this.#positions, solid.positions, place)
    const turn = new Matrix3().setFromMatrix4(place)
    const { normals } = solid
    for (let k = 0; k < normals.length; k += 3) {
      POINT.set(normals[k] ?? 0, normals[k + 1] ?? 0, normals[k + 2] ?? 0).applyMatrix3(turn)
      this.#normals.push(POINT.x, POINT.y, POINT.z)
    }
    const { r, g, b } = new Color(colour)
    const finish = finishBytes(material, this.#positions.slice(3 * start))
    for (let k = 0; k < solid.positions.length; k += 3) {
      this.#finishes.push(...finish)
      if (colours) this.#colours.push(colours[k] ?? 0, colours[k + 1] ?? 0, colours[k + 2] ?? 0)
      else this.#colours.push(r, g, b)
    }
    for (const index of solid.indices) this.#indices.push(start + index)
  }

  build(): BufferGeometry {
    const geometry = new BufferGeometry()
    geometry.setAttribute('position', floats(this.#positions))
    geometry.setAttribute('normal', floats(this.#normals))
    geometry.setAttribute('color', floats(this.#colours))
    geometry.setAttribute('finish', new BufferAttribute(new Uint8Array(this.#finishes), 4, true))
    geometry.setIndex(this.#indices)
    geometry.computeBoundingSphere()
    geometry.computeBoundingBox()
    return geometry
  }
}

/** Line segments of several shapes. */
export class LineParts {
  readonly #positions: number[] = []
  readonly #colours: number[] = []

  add(segments: readonly number[], place: Matrix4, colour: string): void {
    appendMoved(this.#positions, segments, place)
    const { r, g, b } = new Color(colour)
    for (let k = 0; k < segments.length; k += 3) this.#colours.push(r, g, b)
  }

  /** Undefined when there are none. */
  build(): BufferGeometry | undefined {
    if (this.#positions.length === 0) return undefined
    const geometry = new BufferGeometry()
    geometry.setAttribute('position', floats(this.#positions))
    geometry.setAttribute('color', floats(this.#colours))
    geometry.computeBoundingSphere()
    geometry.computeBoundingBox()
    return geometry
  }
}

function appendMoved(out: number[], points: readonly number[], place: Matrix4): void {
  for (let k = 0; k < points.length; k += 3) {
    POINT.set(points[k] ?? 0, points[k + 1] ?? 0, points[k + 2] ?? 0).applyMatrix4(place)
    out.push(POINT.x, POINT.y, POINT.z)
  }
}

function floats(values: number[]): BufferAttribute {
  return new BufferAttribute(new Float32Array(values), 3)
}
