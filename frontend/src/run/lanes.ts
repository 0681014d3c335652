/** What lies above one another on the timeline: tasks and what they call, steps, gripper and signals, findings. */
import { type FindingMark, type InputMark, type Marks, worstLast } from './marks'
import type { ChannelInfo, Run, RunEvent, Series } from './run'
import { lastWhere } from './search'
import { channelOf, labelled } from './station'
import { words } from './words'

export interface Bar {
  readonly from: number
  readonly to: number
  /** Stands in the bar where there is room for it, and in words under the pointer. */
  readonly text: string
  readonly tone: 'task' | 'move' | 'act' | 'wait' | 'held' | 'slowed'
}

export interface Lane {
  readonly kind: 'tasks' | 'steps' | 'held' | 'findings' | 'inputs'
  readonly name: string
  /** Name of the station that it is of; empty for what belongs to the cell. */
  readonly station: string
  /** How deep in the calls a task is. */
  readonly depth: number
  /** In order of their beginnings. */
  readonly bars: readonly Bar[]
  /** In the order in which they are drawn: the worst on top. */
  readonly findings: readonly FindingMark[]
  readonly inputs: readonly InputMark[]
}

/** Name of the channel of the speed override. */
const OVERRIDE = 'override'

/** A switch is on above this. */
const ON = 0.5

/** The lanes of a run, from top to bottom; those that would be empty are left out. */
export function lanesOf(run: Run, marks: Marks): readonly Lane[] {
  const lanes = [
    { ...lane('findings', words.lanes.findings), findings: worstLast(marks.findings) },
    ...run.stations.flatMap(({ name }) => [...taskLanes(run, name), stepLane(run, name, marks)]),
    ...heldLanes(run),
    { ...lane('inputs', words.lanes.inputs), inputs: marks.inputs },
  ]
  return lanes.filter(one => one.bars.length + one.findings.length + one.inputs.length > 0)
}

/** So many lanes of a kind and station are shown at first. */
const FEW: Readonly<Record<Lane['kind'], number>> = { findings: 1, tasks: 3, steps: 1, held: 3, inputs: 1 }
/** The page has no room for more of a kind. */
const MOST = 12

/** Which lanes are shown: the first of each kind, or all. */
export function shownLanes(lanes: readonly Lane[], wanted: 'few' | 'all'): readonly Lane[] {
  const counts = new Map<string, number>()
  return lanes.filter(({ kind, station }) => {
    const key = `${kind} ${station}`
    const count = (counts.get(key) ?? 0) + 1
    counts.set(key, count)
    return count <= (wanted === 'few' ? FEW[kind] : MOST)
  })
}

/** The bar of a lane that covers a time: the last one that has begun. */
export function barAt(bars: readonly Bar[], time: number): Bar | undefined {
  return lastWhere(bars, bar => bar.from <= time && time <= bar.to)
}

function lane(kind: Lane['kind'], name: string, bars: readonly Bar[] = [], station = ''): Lane {
  return { kind, name, station, depth: 0, bars, findings: [], inputs: [] }
}

/** What the program of a station does, step by step. */
function stepLane(run: Run, station: string, marks: Marks): Lane {
  const own = marks.steps.filter(step => step.station === station)
  const bars = own.map<Bar>(step => ({
    from: step.time,
    to: step.end,
    text: `${words.line(step.line)} · ${step.text}`,
    tone: toneOf(step.kind),
  }))
  return lane('steps', labelled(run.stations, station, words.lanes.steps), bars, station)
}

/** Moves stand out, and waits stand back, so that it is seen how long a station is idle. */
function toneOf(kind: string): Bar['tone'] {
  if (kind === 'move' || kind === 'open') return 'move'
  return kind === 'wait' || kind === 'await' ? 'wait' : 'act'
}

/** One lane for each task of a station, a called one below its first caller. */
function taskLanes({ events, stations }: Run, station: string): readonly Lane[] {
  const depthOf = (event: RunEvent) => Number(event.data.depth) || 0
  const tasks = events
    .filter(event => event.kind === 'task' && event.station === station)
    .sort((a, b) => a.time - b.time || depthOf(a) - depthOf(b))
  const least = Math.min(...tasks.map(depthOf))
  const lanes = new Map<string, { depth: number; bars: Bar[] }>()
  for (const event of tasks) {
    const name = String(event.data.name ?? event.text)
    const known = lanes.get(name) ?? { depth: depthOf(event) - least, bars: [] }
    known.bars.push({ from: event.time, to: event.time + event.duration, text: name, tone: 'task' })
    lanes.set(name, known)
  }
  return [...lanes].map(([name, { depth, bars }]) => ({
    ...lane('tasks', labelled(stations, station, name), bars, station),
    depth,
  }))
}

function heldLanes(run: Run): readonly Lane[] {
  const isGripper = ({ name, subject }: ChannelInfo) => name === channelOf('gripper', subject)
  const held = run.channels.filter(one => isGripper(one) || one.name === OVERRIDE || one.group === 'signals')
  return held.map(channel => {
    const { name, subject } = channel
    const series = run.series(name, 0)
    if (name === OVERRIDE)
      return lane('held', words.lanes.override, series ? overrideBars(series, run.duration) : [])
    const bars = series ? heldBars(series, run.duration) : []
    if (!isGripper(channel)) return lane('held', name.replace(/^signal\./, ''), bars)
    const own = run.events.filter(event => event.station === subject)
    return lane(
      'held',
      labelled(run.stations, subject, words.lanes.gripper),
      bars.map(bar => ({ ...bar, text: gripped(own, bar) })),
      subject,
    )
  })
}

/** Stretches in which a value holds; of a switch only those in which it is on. */
export function heldBars(series: Series, end: number): readonly Bar[] {
  const isSwitch = series.values.every(value => value === 0 || value === 1 || Number.isNaN(value))
  return stretches(series, end).flatMap<Bar>(({ from, to, value }) => {
    if (isSwitch) return value > ON ? [{ from, to, text: words.lanes.on, tone: 'held' }] : []
    return Number.isFinite(value)
      ? [{ from, to, text: String(Number(value.toPrecision(4))), tone: 'held' }]
      : []
  })
}

/** What the speed override was, where it has ever been another one than 100 %; at 0 the run is held. */
export function overrideBars(series: Series, end: number): readonly Bar[] {
  if (series.values.every(value => value === 1)) return []
  return stretches(series, end).map(({ from, to, value }) => ({
    from,
    to,
    text: value === 0 ? words.lanes.held : words.lanes.percent(value),
    tone: value < 1 ? 'slowed' : 'held',
  }))
}

/** The stretches of one value each. */
function stretches({ times, values }: Series, end: number) {
  const found: { readonly from: number; readonly to: number; readonly value: number }[] = []
  for (let at = 0; at < times.length; ) {
    const value = values[at] ?? Number.NaN
    const from = times[at] ?? 0
    do at++
    while (at < times.length && Object.is(values[at], value))
    const to = at < times.length ? (times[at] ?? end) : end
    if (to > from) found.push({ from, to, value })
  }
  return found
}

/** What the gripper holds: the part of the grip that closed it, which a live run sees a frame later. */
function gripped(events: readonly RunEvent[], bar: Bar): string {
  const moved = lastWhere(
    events,
    one => (one.kind === 'grip' || one.kind === 'release') && one.time <= bar.from + 1e-6,
  )
  const part = moved?.kind === 'grip' ? moved.data.part : ''
  return typeof part === 'string' && part ? part : words.lanes.closed
}
