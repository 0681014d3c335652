/** Speed of the TCP, which is not recorded: from its positions. */
import type { ChannelInfo, Series } from './run'
import { channelOf } from './station'

export const TCP_SPEED = 'tcp_speed'

export function speedChannel(station: string, speed: Series | undefined): ChannelInfo {
  let greatest = Number.NaN
  // Comparing with NaN is false: gaps do not count, the first value does.
  for (const value of speed?.values ?? []) if (value >= 0 && !(value <= greatest)) greatest = value
  return {
    name: channelOf(TCP_SPEED, station),
    unit: 'm/s',
    columns: [''],
    description: 'attained speed of the TCP, from its positions',
    group: 'tcp',
    subject: station,
    min: [0],
    max: [greatest],
  }
}

/** Steps of time that are shorter say more of the digits of a position than of its speed [s]. */
const LEAST_STEP = 2e-3

/**
 * The slope of the parabola through each position and its neighbours, which may lie at any distances: the slope on
 * either side, weighted by the length of the other one. For equal steps these are central differences.
 * Undefined where a coordinate is missing.
 */
export function speedOf(position: readonly (Series | undefined)[]): Series | undefined {
  const [x, y, z] = position
  if (!x || !y || !z) return undefined
  const times = [x, y, z].reduce(
    (longest, one) => (one.times.length > longest.length ? one.times : longest),
    x.times,
  )
  const values = new Float64Array(times.length)
  for (let k = 0; k < times.length; k++) {
    const [a, b] = [neighbour(times, k, -1), neighbour(times, k, 1)]
    values[k] = Math.hypot(slope(x, times, a, k, b), slope(y, times, a, k, b), slope(z, times, a, k, b))
  }
  return { times, values, held: false }
}

/** The next sample in a direction that is not too near; the last one where there is none. */
function neighbour(times: Float64Array, of: number, way: 1 | -1): number {
  const last = way > 0 ? times.length - 1 : 0
  const from = times[of] ?? 0
  let at = of
  while (at !== last && Math.abs((times[at] ?? 0) - from) < LEAST_STEP) at += way
  return at
}

/** A coordinate that never changes is stored as held: it does not move. */
function slope({ values, held }: Series, times: Float64Array, a: number, k: number, b: number): number {
  if (held) return 0
  const number = (of: Float64Array, at: number) => of[at] ?? Number.NaN
  const [before, after] = [number(times, k) - number(times, a), number(times, b) - number(times, k)]
  const [fallen, risen] = [number(values, k) - number(values, a), number(values, b) - number(values, k)]
  if (before === 0 || after === 0) return before + after > 0 ? (fallen + risen) / (before + after) : 0
  return ((fallen / before) * after + (risen / after) * before) / (before + after)
}

/** A value between the samples of a series. */
export function valueIn({ times, values }: Series, index: number, share: number): number {
  const from = values[index] ?? Number.NaN
  const to = values[Math.min(index + 1, times.length - 1)] ?? from
  return from + (to - from) * share
}
