/** Where a contour and the attained path lie in a picture. */
import type { Contour } from '../run/run'

/** Size of the picture in units of its own. */
export const WIDTH = 240
export const HEIGHT = 200
const MARGIN = 12

type Points = readonly (readonly [number, number])[]

/** Points of both curves as SVG writes them: to equal scales, the second axis upwards. */
export function contourPicture({ wanted, attained }: Contour): { wanted: string; attained: string } {
  const all = [...wanted, ...attained]
  const [left, right] = extent(all.map(([x]) => x))
  const [low, high] = extent(all.map(([, y]) => y))
  const room = (size: number) => size - 2 * MARGIN
  const scale = Math.min(
    room(WIDTH) / Math.max(right - left, 1e-9),
    room(HEIGHT) / Math.max(high - low, 1e-9),
  )
  const x = (value: number) => WIDTH / 2 + (value - (left + right) / 2) * scale
  const y = (value: number) => HEIGHT / 2 - (value - (low + high) / 2) * scale
  const drawn = (points: Points) => points.map(([a, b]) => `${x(a).toFixed(1)},${y(b).toFixed(1)}`).join(' ')
  return { wanted: drawn(wanted), attained: drawn(attained) }
}

function extent(values: readonly number[]): [number, number] {
  return [Math.min(...values), Math.max(...values)]
}
