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

/** Central differences of positions that are sampled together; undefined where one is missing. */
export function speedOf(position: readonly (Series | undefined)[]): Series | undefined {
  const [x, y, z] = position
  if (!x || !y || !z) return undefined
  const times = [x, y, z].reduce(
    (longest, one) => (one.times.length > longest.length ? one.times : longest),
    x.times,
  )
  const count = times.length
  const values = new Float64Array(count)
  for (let k = 0; k < count; k++) {
    const [a, b] = [Math.max(k - 1, 0), Math.min(k + 1, count - 1)]
    const span = (times[b] ?? 0) - (times[a] ?? 0)
    values[k] = span > 0 ? Math.hypot(step(x, a, b), step(y, a, b), step(z, a, b)) / span : 0
  }
  return { times, values, held: false }
}

/** A coordinate that never changes is stored as held: it does not move. */
function step(series: Series, from: number, to: number): number {
  return series.held ? 0 : (series.values[to] ?? Number.NaN) - (series.values[from] ?? Number.NaN)
}

/** A value between the samples of a series. */
export function valueIn({ times, values }: Series, index: number, share: number): number {
  const from = values[index] ?? Number.NaN
  const to = values[Math.min(index + 1, times.length - 1)] ?? from
  return from + (to - from) * share
}
