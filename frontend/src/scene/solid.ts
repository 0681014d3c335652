/** A surface as numbers: triangles with normals, and the lines that show its form. */

export interface Solid {
  /** Corners x, y, z [m] and outward unit normals, three numbers per corner. */
  readonly positions: number[]
  readonly normals: number[]
  /** Three corners per triangle, counter-clockwise seen from outside. */
  readonly indices: number[]
  /** Line segments (two points, six numbers each) where the surface has an edge. */
  readonly creases: number[]
  /** Line segments along round faces: drawn only where lines are all there is to see. */
  readonly contours: number[]
  /** Seen from both sides. */
  readonly open: boolean
}

export function emptySolid(open: boolean): Solid {
  return { positions: [], normals: [], indices: [], creases: [], contours: [], open }
}

/** Neighbouring faces that turn by less than this meet smoothly [rad]. */
export const SMOOTH_ANGLE = 0.62

/** Number of chords of a circle that a viewer takes for round. */
export function chords(radius: number): number {
  const sagitta = 0.0004
  const wanted = radius > sagitta ? Math.PI / Math.acos(1 - sagitta / radius) : 0
  return 4 * Math.ceil(Math.min(Math.max(wanted, 16), 48) / 4)
}

/** Volume that a closed surface encloses; negative when it is inside out [m³]. */
export function volume(solid: Solid): number {
  const { positions: p, indices } = solid
  let sum = 0
  for (let k = 0; k < indices.length; k += 3) {
    const [a, b, c] = [3 * (indices[k] ?? 0), 3 * (indices[k + 1] ?? 0), 3 * (indices[k + 2] ?? 0)]
    const at = (i: number) => p[i] ?? 0
    sum +=
      at(a) * (at(b + 1) * at(c + 2) - at(b + 2) * at(c + 1)) +
      at(a + 1) * (at(b + 2) * at(c) - at(b) * at(c + 2)) +
      at(a + 2) * (at(b) * at(c + 1) - at(b + 1) * at(c))
  }
  return sum / 6
}
