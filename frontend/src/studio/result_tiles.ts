/** The result of a run as tiles: each a figure, in words, with the moment and the line where it arises. */

import type { Run } from '../run/run'
import { labelled } from '../run/station'
import { resultWords as words } from '../text/result'
import { jointName, partsOf } from '../units/names'
import { formatQuantity } from '../units/quantity'
import type { Destinations } from '../wire/facts'
import type { ResultFigures } from '../wire/result'

export interface Tile {
  readonly id: 'parts' | 'cycle' | 'settling' | 'torque' | 'limit' | 'path' | 'findings'
  readonly label: string
  readonly value: string
  /** A few words below the value, such as which joint it is. */
  readonly detail: string
  readonly tone: 'plain' | 'warning' | 'error'
  /** Where a click leads [s]; null for nowhere. */
  readonly time: number | null
  /** Name of the text in which `line` counts. */
  readonly source: string
  /** From 1; 0 for none. */
  readonly line: number
}

const TONES = { far: 'plain', near: 'warning', beyond: 'error' } as const

export function tilesOf(run: Run, result: ResultFigures): readonly Tile[] {
  return [
    cycle(run, result),
    settling(run, result),
    torque(run, result),
    limit(run, result),
    path(run, result),
    ...(result.destinations ? [parts(run, result.destinations)] : []),
    findings(run, result),
  ]
}

/** Of the parts with a destination those that are there; the moment is the end of the run. */
function parts(run: Run, { wanted, reached }: Destinations): Tile {
  return {
    ...NOWHERE,
    id: 'parts',
    label: words.parts,
    value: words.reached(reached, wanted),
    detail: reached < wanted ? words.away(wanted - reached) : '',
    tone: reached < wanted ? 'warning' : 'plain',
    time: run.duration,
  }
}

function cycle(run: Run, { cycle_time, cycle_time_valid, cycle_time_by_hand }: ResultFigures): Tile {
  return {
    ...NOWHERE,
    id: 'cycle',
    label: words.cycle,
    value: formatQuantity(cycle_time, 's'),
    detail: cycle_time_valid ? cycle_time_by_hand : words.notValid,
    tone: cycle_time_valid ? (cycle_time_by_hand ? 'warning' : 'plain') : 'error',
    time: run.duration,
  }
}

/** The click leads to the longest wait of all. */
function settling(run: Run, { settling }: ResultFigures): Tile {
  if (!settling) {
    return { ...NOWHERE, id: 'settling', label: words.settling, value: '–', detail: words.withoutDrives }
  }
  const { total, share, time, station, line } = settling
  return {
    id: 'settling',
    label: words.settling,
    value: formatQuantity(total, 's'),
    detail: run.stations.length > 1 ? words.ofCycles(percent(share)) : words.ofCycle(percent(share)),
    tone: 'plain',
    time,
    source: sourceOf(run, station),
    line,
  }
}

function torque(run: Run, { peak_torque }: ResultFigures): Tile {
  if (!peak_torque) return { ...NOWHERE, id: 'torque', label: words.torque, value: '–', detail: noShare(run) }
  const { share, closeness, station, joint, line, time } = peak_torque
  return {
    id: 'torque',
    label: words.torque,
    value: percent(share),
    detail: labelled(run.stations, station, jointName(joint)),
    tone: TONES[closeness],
    source: sourceOf(run, station),
    line,
    time,
  }
}

function limit(run: Run, { closest_limit }: ResultFigures): Tile {
  if (!closest_limit) return { ...NOWHERE, id: 'limit', label: words.limit, value: '–', detail: '' }
  const { margin, closeness, unit, station, joint, side, line, time } = closest_limit
  return {
    id: 'limit',
    label: words.limit,
    value: formatQuantity(margin, unit),
    detail: words.side(labelled(run.stations, station, jointName(joint)), side),
    tone: TONES[closeness],
    source: sourceOf(run, station),
    line,
    time,
  }
}

function path(run: Run, { path_error }: ResultFigures): Tile {
  if (!path_error) {
    const detail = isDriven(run) ? words.noPath : words.withoutDrives
    return { ...NOWHERE, id: 'path', label: words.path, value: '–', detail }
  }
  const { max, station, line, time } = path_error
  return {
    id: 'path',
    label: words.path,
    value: formatSmall(max),
    detail: labelled(run.stations, station, words.line(line)),
    tone: 'plain',
    source: sourceOf(run, station),
    line,
    time,
  }
}

function findings(run: Run, { errors, warnings, hints }: ResultFigures): Tile {
  const rank = { error: 0, warning: 1, info: 2, hint: 3 } as const
  const [first] = [...run.findings].sort(
    (a, b) => rank[a.severity] - rank[b.severity] || (a.time ?? Infinity) - (b.time ?? Infinity),
  )
  return {
    id: 'findings',
    label: words.findings,
    value: String(errors + warnings + hints),
    detail: words.counts(errors, warnings, hints),
    tone: errors ? 'error' : warnings ? 'warning' : 'plain',
    time: first?.time ?? null,
    source: first?.span?.source ?? '',
    line: first?.span?.line ?? 0,
  }
}

const NOWHERE = { tone: 'plain', time: null, source: '', line: 0 } as const

/** Why no torque is a share of a limit: none was simulated, or the model does not say how much there is. */
function noShare(run: Run): string {
  return isDriven(run) ? words.limitUnknown : words.notSimulated
}

/** Whether drives moved an arm of the run. */
function isDriven({ channels }: Run): boolean {
  return channels.some(({ name }) => partsOf(name).quantity === 'tau')
}

/** Name of the text that a station runs. */
function sourceOf(run: Run, station: string): string {
  return run.stations.find(one => one.name === station)?.source ?? ''
}

function percent(share: number): string {
  const number = 100 * share
  return `${number < 10 && number > 0 ? number.toFixed(1) : number.toFixed(0)} %`
}

/** Path errors are far below the tenth of a millimetre in which lengths are told. */
function formatSmall(value: number): string {
  const rough = formatQuantity(value, 'm')
  return rough.endsWith(' mm') ? `${(1000 * value).toPrecision(2)} mm` : rough
}
