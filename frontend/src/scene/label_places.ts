/** Where names stand so that none lies upon another: the most important first, what finds no place is left out. */
import type { Rect } from './layouts'

export interface Wanted {
  /** The point that is named [px]. */
  readonly x: number
  readonly y: number
  /** Size of the name [px]. */
  readonly width: number
  readonly height: number
  /** Lower ones come first. */
  readonly rank: number
}

export interface Spot {
  readonly left: number
  readonly top: number
}

/** From the point to the name [px]. */
const GAP = { x: 6, y: 4 } as const

/**
 * A spot for each name in a picture of this size, null for those without. Names stand to the lower right of their
 * point, else to the upper right, lower left or upper left. `taken` is covered already.
 */
export function arrange(
  wanted: readonly Wanted[],
  size: Pick<Rect, 'width' | 'height'>,
  taken: readonly Rect[] = [],
): (Spot | null)[] {
  const covered = [...taken]
  const spots: (Spot | null)[] = wanted.map(() => null)
  const order = wanted
    .map((_, k) => k)
    .sort((a, b) => (wanted[a]?.rank ?? 0) - (wanted[b]?.rank ?? 0) || a - b)
  for (const k of order) {
    const one = wanted[k]
    if (!one) continue
    const { width, height } = one
    for (const { left, top } of spotsOf(one)) {
      const rect = { x: left, y: top, width, height }
      const inside = left >= 0 && top >= 0 && left + width <= size.width && top + height <= size.height
      if (!inside || covered.some(other => overlap(rect, other))) continue
      covered.push(rect)
      spots[k] = { left, top }
      break
    }
  }
  return spots
}

function spotsOf({ x, y, width, height }: Wanted): readonly Spot[] {
  const [right, left] = [Math.round(x) + GAP.x, Math.round(x) - GAP.x - width]
  const [below, above] = [Math.round(y) + GAP.y, Math.round(y) - GAP.y - height]
  return [
    { left: right, top: below },
    { left: right, top: above },
    { left, top: below },
    { left, top: above },
  ]
}

function overlap(a: Rect, b: Rect): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height
}
