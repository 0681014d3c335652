/** Several series on one time axis, as the drawing library wants them. */
import type { Points } from './decimate'

/** No sample of this series at this time; null breaks the line, undefined does not. */
export type Cell = number | null | undefined

export interface Table {
  readonly times: number[]
  readonly columns: Cell[][]
}

/** Join the points of several series; values are scaled, gaps become null, absent samples undefined. */
export function joinPoints(series: readonly Points[], factors: readonly number[]): Table {
  const times = [...new Set(series.flatMap(one => [...one.times]))].sort((a, b) => a - b)
  const columns = series.map((one, which) => {
    const factor = factors[which] ?? 1
    let at = 0
    return times.map((time): Cell => {
      // Two samples of one time (a step without width): the later one counts.
      let found = -1
      while (at < one.times.length && (one.times[at] ?? 0) <= time) found = at++
      if (found < 0 || one.times[found] !== time) return undefined
      const value = one.values[found] ?? Number.NaN
      return Number.isNaN(value) ? null : value * factor
    })
  })
  return { times, columns }
}
