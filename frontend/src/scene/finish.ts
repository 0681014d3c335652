/** What each material looks like: how sharply a surface mirrors, how much of it is metal, which way its grain runs. */
import type { Material } from './description'

export interface Finish {
  /** 0: matt, 1: polished. */
  readonly gloss: number
  /** Share of the light that bare metal throws back in its own colour. */
  readonly metal: number
  /** Whether fibres are drawn along the longest side. */
  readonly grain: boolean
}

export const FINISHES: Record<Material, Finish> = {
  paint: { gloss: 0.55, metal: 0, grain: false },
  steel: { gloss: 0.62, metal: 0.85, grain: false },
  wood: { gloss: 0.18, metal: 0, grain: true },
  cardboard: { gloss: 0.05, metal: 0, grain: false },
  rubber: { gloss: 0.1, metal: 0, grain: false },
  glass: { gloss: 0.95, metal: 0, grain: false },
}

const FULL = 255

/** Four bytes for each corner of a surface: gloss, metal, axis of the grain (0: none, else 85 for each of x, y, z). */
export function finishBytes(material: Material, positions: ArrayLike<number>): readonly number[] {
  const { gloss, metal, grain } = FINISHES[material]
  const axis = grain ? 85 * (1 + longestAxis(positions)) : 0
  return [Math.round(FULL * gloss), Math.round(FULL * metal), axis, 0]
}

/** The axis along which points reach farthest: 0, 1 or 2. */
export function longestAxis(points: ArrayLike<number>): number {
  const low = [0, 1, 2].map(() => Number.POSITIVE_INFINITY)
  const high = [0, 1, 2].map(() => Number.NEGATIVE_INFINITY)
  for (let k = 0; k < points.length; k++) {
    const [axis, at] = [k % 3, points[k] ?? 0]
    low[axis] = Math.min(low[axis] ?? at, at)
    high[axis] = Math.max(high[axis] ?? at, at)
  }
  const reach = [0, 1, 2].map(axis => (high[axis] ?? 0) - (low[axis] ?? 0))
  return reach.indexOf(Math.max(...reach))
}
