/** What is plotted: columns of a run with their names, units and points. */
import { unitOf } from '../run/column_units'
import type { Run } from '../run/run'
import { columnName, symbolOf } from '../units/names'
import { shownUnit } from '../units/quantity'
import { decimate, type Points } from './decimate'

export interface PlotColumn {
  readonly channel: string
  readonly column: number
}

export interface Trace {
  readonly name: string
  /** As models and recordings call it. */
  readonly symbol: string
  readonly unit: string
  readonly column: PlotColumn
  /** The values hold between changes: drawn as steps. */
  readonly held: boolean
}

const NO_POINTS: Points = { times: new Float64Array(0), values: new Float64Array(0) }

/** The columns that the run has. */
export function tracesOf(run: Run, columns: readonly PlotColumn[]): readonly Trace[] {
  return columns.flatMap(column => {
    const channel = run.channels.find(one => one.name === column.channel)
    const name = channel?.columns[column.column]
    if (!channel || name === undefined) return []
    return [
      {
        name: columnName(channel.name, name),
        symbol: symbolOf(channel.name, name),
        unit: unitOf(channel, column.column),
        column,
        held: run.series(column.channel, column.column)?.held ?? false,
      },
    ]
  })
}

/** Name of the scale of a trace: traces of one shown unit share it. */
export function scaleOf(trace: Trace): string {
  return shownUnit(trace.unit).unit || '1'
}

export function unitsOf(traces: readonly Trace[]): readonly string[] {
  return [...new Set(traces.map(scaleOf))]
}

/** Points of a trace between two times, few enough for `width` pixels. */
export function pointsOf(
  run: Run,
  { column }: Trace,
  [from, to]: readonly [number, number],
  width: number,
): Points {
  const series = run.series(column.channel, column.column)
  if (!series) return NO_POINTS
  const points = decimate(series, from, to, width)
  return series.held ? heldUntil(points, run.duration) : points
}

/** A value that holds is drawn to the end of the run. */
function heldUntil(points: Points, end: number): Points {
  const last = points.times.at(-1)
  if (last === undefined || last >= end) return points
  return {
    times: Float64Array.of(...points.times, end),
    values: Float64Array.of(...points.values, points.values.at(-1) ?? Number.NaN),
  }
}
