/** A run as a table of comma-separated values (RFC 4180): named columns in the units that are shown. */
import { columnName } from '../units/names'
import { shownUnit } from '../units/quantity'
import { unitOf } from './column_units'
import type { Run } from './run'

/** Figures of a number: more than any recorded quantity has. */
const FIGURES = 9

export function csvOf(run: Run): string {
  const columns = run.channels.flatMap(channel =>
    channel.columns.map((name, column) => {
      const { unit, factor } = shownUnit(unitOf(channel, column))
      const title = columnName(channel.name, name)
      return { channel: channel.name, column, factor, title: unit ? `${title} [${unit}]` : title }
    }),
  )
  const lines = [['Time [s]', ...columns.map(one => quoted(one.title))].join(',')]
  for (const time of timesOf(run)) {
    const values = columns.map(one => number(run.value(one.channel, one.column, time) * one.factor))
    lines.push([number(time), ...values].join(','))
  }
  return `${lines.join('\r\n')}\r\n`
}

/** The times of the column that has most samples. */
function timesOf(run: Run): ArrayLike<number> & Iterable<number> {
  let times: Float64Array = new Float64Array(0)
  for (const { name, columns } of run.channels) {
    for (let column = 0; column < columns.length; column++) {
      const series = run.series(name, column)
      if (series && series.times.length > times.length) times = series.times
    }
  }
  return times
}

function number(value: number): string {
  return Number.isFinite(value) ? String(Number(value.toPrecision(FIGURES))) : ''
}

function quoted(text: string): string {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}
