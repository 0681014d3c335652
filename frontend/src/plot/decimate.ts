/** Fewer points for the same picture: per pixel column the least and the greatest value, so that peaks stay. */
import type { Series } from '../run/run'

export interface Points {
  readonly times: Float64Array
  /** NaN where there is no value. */
  readonly values: Float64Array
}

/** First index whose time is not below `time`. */
export function lowerBound(times: Float64Array, time: number): number {
  let low = 0
  let high = times.length
  while (low < high) {
    const middle = (low + high) >> 1
    if ((times[middle] ?? 0) < time) low = middle + 1
    else high = middle
  }
  return low
}

/**
 * The samples of a series between two times, one beyond on each side, at most about four per pixel column:
 * first, least, greatest and last. Gaps stay gaps.
 */
export function decimate(series: Series, from: number, to: number, columns: number): Points {
  const { times, values } = series
  const begin = Math.max(lowerBound(times, from) - 1, 0)
  const end = Math.min(lowerBound(times, to) + 2, times.length)
  if (end - begin <= 4 * columns) return { times: times.slice(begin, end), values: values.slice(begin, end) }
  const chosen: number[] = []
  const width = (to - from) / columns
  let at = begin
  while (at < end) {
    const column = Math.floor(((times[at] ?? 0) - from) / width)
    let next = at + 1
    while (next < end && Math.floor(((times[next] ?? 0) - from) / width) === column) next++
    choose(values, at, next, chosen)
    at = next
  }
  return {
    times: Float64Array.from(chosen, index => times[index] ?? 0),
    values: Float64Array.from(chosen, index => values[index] ?? Number.NaN),
  }
}

/** Indices of first, least, greatest, a gap if there is one, and last, in order. */
function choose(values: Float64Array, begin: number, end: number, chosen: number[]): void {
  let least = -1
  let greatest = -1
  let gap = -1
  for (let index = begin; index < end; index++) {
    const value = values[index] ?? Number.NaN
    if (Number.isNaN(value)) {
      gap = index
      continue
    }
    if (least < 0 || value < (values[least] ?? 0)) least = index
    if (greatest < 0 || value > (values[greatest] ?? 0)) greatest = index
  }
  const wanted = [begin, least, greatest, gap, end - 1].filter(index => index >= 0).sort((a, b) => a - b)
  for (const index of wanted) if (chosen.at(-1) !== index) chosen.push(index)
}
