/** What lies above one another on the timeline: tasks and what they call, steps, gripper and signals, findings. */
import { type FindingMark, type InputMark, type Marks, worstLast } from './marks'
import type { Run, RunEvent, Series } from './run'
import { lastWhere } from './search'
import { words } from './words'

export interface Bar {
  readonly from: number
  readonly to: number
  /** Stands in the bar where there is room for it, and in words under the pointer. */
  readonly text: string
  readonly tone: 'task' | 'move' | 'wait' | 'held'
}

export interface Lane {
  readonly kind: 'tasks' | 'steps' | 'held' | 'findings' | 'inputs'
  readonly name: string
  /** How deep in the calls a task is. */
  readonly depth: number
  /** In order of their beginnings. */
  readonly bars: readonly Bar[]
  /** In the order in which they are drawn: the worst on top. */
  readonly findings: readonly FindingMark[]
  readonly inputs: readonly InputMark[]
}

/** A switch is on above this. */
const ON = 0.5

/** The lanes of a run, from top to bottom; those that would be empty are left out. */
export function lanesOf(run: Run, marks: Marks): readonly Lane[] {
  const steps = marks.steps.map<Bar>(step => ({
    from: step.time,
    to: step.end,
    text: `${words.line(step.line)} · ${step.text}`,
    tone: step.kind === 'move' ? 'move' : 'wait',
  }))
  const lanes = [
    { ...lane('findings', words.lanes.findings), findings: worstLast(marks.findings) },
    ...taskLanes(run.events),
    lane('steps', words.lanes.steps, steps),
    ...heldLanes(run),
    { ...lane('inputs', words.lanes.inputs), inputs: marks.inputs },
  ]
  return lanes.filter(one => one.bars.length + one.findings.length + one.inputs.length > 0)
}

/** So many lanes of a kind are shown at first. */
const FEW: Readonly<Record<Lane['kind'], number>> = { findings: 1, tasks: 3, steps: 1, held: 3, inputs: 1 }
/** The page has no room for more of a kind. */
const MOST = 12

/** Which lanes are shown: the first of each kind, or all. */
export function shownLanes(lanes: readonly Lane[], wanted: 'few' | 'all'): readonly Lane[] {
  const counts = new Map<Lane['kind'], number>()
  return lanes.filter(({ kind }) => {
    const count = (counts.get(kind) ?? 0) + 1
    counts.set(kind, count)
    return count <= (wanted === 'few' ? FEW[kind] : MOST)
  })
}

/** The bar of a lane that covers a time: the last one that has begun. */
export function barAt(bars: readonly Bar[], time: number): Bar | undefined {
  return lastWhere(bars, bar => bar.from <= time && time <= bar.to)
}

function lane(kind: Lane['kind'], name: string, bars: readonly Bar[] = []): Lane {
  return { kind, name, depth: 0, bars, findings: [], inputs: [] }
}

/** One lane for each task, a called one below its first caller. */
function taskLanes(events: readonly RunEvent[]): readonly Lane[] {
  const depthOf = (event: RunEvent) => Number(event.data.depth) || 0
  const tasks = events
    .filter(event => event.kind === 'task')
    .sort((a, b) => a.time - b.time || depthOf(a) - depthOf(b))
  const least = Math.min(...tasks.map(depthOf))
  const lanes = new Map<string, { depth: number; bars: Bar[] }>()
  for (const event of tasks) {
    const name = String(event.data.name ?? event.text)
    const known = lanes.get(name) ?? { depth: depthOf(event) - least, bars: [] }
    known.bars.push({ from: event.time, to: event.time + event.duration, text: name, tone: 'task' })
    lanes.set(name, known)
  }
  return [...lanes].map(([name, { depth, bars }]) => ({ ...lane('tasks', name, bars), depth }))
}

function heldLanes(run: Run): readonly Lane[] {
  const names = run.channels
    .filter(one => one.name === 'gripper' || one.group === 'signals')
    .map(one => one.name)
  return names.map(name => {
    const series = run.series(name, 0)
    const bars = series ? heldBars(series, run.duration) : []
    if (name !== 'gripper') return lane('held', name.replace(/^signal\./, ''), bars)
    return lane(
      'held',
      words.lanes.gripper,
      bars.map(bar => ({ ...bar, text: gripped(run.events, bar) })),
    )
  })
}

/** Stretches in which a value holds; of a switch only those in which it is on. */
export function heldBars({ times, values }: Series, end: number): readonly Bar[] {
  const isSwitch = values.every(value => value === 0 || value === 1 || Number.isNaN(value))
  const bars: Bar[] = []
  for (let at = 0; at < times.length; ) {
    const value = values[at] ?? Number.NaN
    const from = times[at] ?? 0
    do at++
    while (at < times.length && Object.is(values[at], value))
    const to = at < times.length ? (times[at] ?? end) : end
    const shown = isSwitch ? value > ON : Number.isFinite(value)
    const text = isSwitch ? words.lanes.on : String(Number(value.toPrecision(4)))
    if (shown && to > from) bars.push({ from, to, text, tone: 'held' })
  }
  return bars
}

/** What the gripper holds: the part of the grip that closed it. */
function gripped(events: readonly RunEvent[], bar: Bar): string {
  const grip = lastWhere(
    events,
    one => one.kind === 'grip' && one.time <= bar.from + 1e-6 && one.time + one.duration >= bar.from - 1e-6,
  )
  const part = grip?.data.part
  return typeof part === 'string' && part ? part : words.lanes.closed
}
