/** Rows of the table of states: every column of every channel, with the range its bar stands for. */
import { unitOf } from '../run/column_units'
import type { ChannelInfo } from '../run/run'
import { channelOf } from '../run/station'
import type { JointDescription, StationDescription } from '../scene/description'
import { columnName, jointName, symbolOf } from '../units/names'

export interface StateRow {
  readonly key: string
  readonly channel: string
  readonly column: number
  readonly name: string
  /** As models and recordings call it. */
  readonly symbol: string
  readonly description: string
  readonly unit: string
  readonly group: string
  readonly min: number
  readonly max: number
  readonly jointName: string
  /** Name of the station or device; empty for the cell. */
  readonly subject: string
  /** Index of the joint whose coordinate it is, -1 for none. */
  readonly joint: number
}

/** Ranges of joints are their limits, others what the run reached. */
export function stateRows(
  channels: readonly ChannelInfo[],
  stations: readonly StationDescription[],
): readonly StateRow[] {
  return channels.flatMap(channel => {
    const joints = stations.find(one => one.name === channel.subject)?.joints ?? []
    return channel.columns.map((name, column) => {
      const joint = channel.columns.length === joints.length ? joints[column] : undefined
      const [min, max] = rangeOf(channel, column, joint)
      return {
        key: `${channel.name}/${column}`,
        channel: channel.name,
        column,
        name: columnName(channel.name, name),
        symbol: symbolOf(channel.name, name),
        jointName: joint ? jointName(joint.name) : '',
        description: channel.description,
        unit: unitOf(channel, column),
        group: channel.group,
        min,
        max,
        subject: channel.subject,
        joint: isOf(channel, 'q') && joint ? column : -1,
      }
    })
  })
}

function isOf(channel: ChannelInfo, ...quantities: readonly string[]): boolean {
  return quantities.some(quantity => channel.name === channelOf(quantity, channel.subject))
}

function rangeOf(
  channel: ChannelInfo,
  column: number,
  joint: JointDescription | undefined,
): readonly [number, number] {
  if (joint && isOf(channel, 'q', 'q_ref')) return [joint.lower, joint.upper]
  if (joint && isOf(channel, 'qd', 'qd_ref')) return [-joint.maxSpeed, joint.maxSpeed]
  return [channel.min[column] ?? Number.NaN, channel.max[column] ?? Number.NaN]
}

/** Rows of a group whose name, symbol or description holds all words. */
export function filterRows(rows: readonly StateRow[], group: string, query: string): readonly StateRow[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean)
  return rows.filter(
    row =>
      (group === '' || row.group === group) &&
      words.every(word => `${row.name} ${row.symbol} ${row.description}`.toLowerCase().includes(word)),
  )
}

/** Where a value lies between two ends, 0 … 1; 0 where that means nothing. */
export function share(value: number, min: number, max: number): number {
  const part = (value - min) / (max - min)
  return Number.isFinite(part) ? Math.min(Math.max(part, 0), 1) : 0
}
