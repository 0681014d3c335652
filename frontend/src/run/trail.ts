/** The way of the TCP: positions in the base frame become points in W. */
import type { Pose } from '../scene/description'
import type { Series } from './run'

export interface Trail {
  readonly times: Float64Array
  readonly points: Float32Array
}

const NO_TRAIL: Trail = { times: new Float64Array(0), points: new Float32Array(0) }

/** Points X_WB · p of three columns that share their times; empty where one of them is absent. */
export function trailOf(
  times: Float64Array,
  position: readonly (Series | undefined)[],
  base: Pose | undefined,
): Trail {
  const [x, y, z] = position
  if (!x || !y || !z || !base) return NO_TRAIL
  const points = new Float32Array(3 * times.length)
  const [bx, by, bz, w, i, j, k] = base
  for (let n = 0; n < times.length; n++) {
    const px = sample(x, n)
    const py = sample(y, n)
    const pz = sample(z, n)
    const cx = 2 * (j * pz - k * py)
    const cy = 2 * (k * px - i * pz)
    const cz = 2 * (i * py - j * px)
    points[3 * n] = bx + px + w * cx + j * cz - k * cy
    points[3 * n + 1] = by + py + w * cy + k * cx - i * cz
    points[3 * n + 2] = bz + pz + w * cz + i * cy - j * cx
  }
  return { times, points }
}

/** A column that never moved is a constant with two samples. */
function sample(series: Series, n: number): number {
  return series.values[series.held ? 0 : n] ?? Number.NaN
}
