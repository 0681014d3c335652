/** What the timeline marks: steps of the program, findings and presses of keys, in order of time. */
import type { Finding, Run, RunEvent, Series } from './run'
import { countUpTo } from './search'
import { channelOf } from './station'
import { words } from './words'

/** A stretch of the run that belongs to one line of the program. */
export interface StepMark {
  readonly time: number
  readonly end: number
  readonly kind: string
  /** Name of the station whose program it is. */
  readonly station: string
  readonly line: number
  readonly text: string
}

export interface FindingMark {
  readonly time: number
  readonly severity: Finding['severity']
  readonly text: string
}

/** An input that was set from outside: by a key of a live run, or as such a run was recorded. */
export interface InputMark {
  readonly time: number
  /** Signal and value. */
  readonly text: string
}

export interface Marks {
  readonly steps: readonly StepMark[]
  readonly findings: readonly FindingMark[]
  readonly inputs: readonly InputMark[]
}

export const NO_MARKS: Marks = { steps: [], findings: [], inputs: [] }

/** Times nearer than this are the same step [s]: far below a control tick. */
const SAME = 1e-6

export function marksOf(run: Run): Marks {
  const steps = run.events.filter(isStep).map(event => ({
    time: event.time,
    end: event.time + event.duration,
    kind: event.kind,
    station: event.station,
    line: event.span?.line ?? 0,
    text: event.text,
  }))
  for (const { name } of run.live ? run.stations : []) steps.push(...openSteps(run, name, steps))
  const findings = run.findings.flatMap(one =>
    one.time === null ? [] : [{ time: one.time, severity: one.severity, text: `${one.code} ${one.message}` }],
  )
  const inputs = run.events.filter(one => one.kind === 'input').map(({ time, text }) => ({ time, text }))
  // Of findings at the same time the worst is told.
  return { steps: inOrder(steps), findings: inOrder([...worstLast(findings)]), inputs: inOrder(inputs) }
}

/** The first mark after `time`, or undefined. */
export function firstAfter<M extends { readonly time: number }>(
  marks: readonly M[],
  time: number,
): M | undefined {
  return marks[countUpTo(marks, time + SAME, timeOf)]
}

/** The last mark before `time`, or undefined. */
export function lastBefore<M extends { readonly time: number }>(
  marks: readonly M[],
  time: number,
): M | undefined {
  return marks[countUpTo(marks, time - SAME, timeOf) - 1]
}

/** The step that runs at `time`: the last one that has begun. */
export function stepAt(marks: Marks, time: number): StepMark | undefined {
  return marks.steps[countUpTo(marks.steps, time + SAME, timeOf) - 1]
}

/** The mark nearest to `time`, at most `reach` away. */
export function nearest<M extends { readonly time: number }>(
  marks: readonly M[],
  time: number,
  reach: number,
): M | undefined {
  let best: M | undefined
  let least = reach
  for (const mark of marks) {
    const distance = Math.abs(mark.time - time)
    if (distance <= least) {
      best = mark
      least = distance
    }
  }
  return best
}

const SEVERITIES: readonly Finding['severity'][] = ['hint', 'info', 'warning', 'error']

/** The worst come last, each severity in its order of time: what is drawn last covers what was there before. */
export function worstLast(findings: readonly FindingMark[]): readonly FindingMark[] {
  return [...findings].sort((a, b) => SEVERITIES.indexOf(a.severity) - SEVERITIES.indexOf(b.severity))
}

function timeOf(mark: { readonly time: number }): number {
  return mark.time
}

/** Steps of a live run whose events have not come: they come with the end of a step. */
function openSteps(run: Run, station: string, known: readonly StepMark[]): readonly StepMark[] {
  const lines = run.series(channelOf('line', station), 0)
  if (!lines) return []
  const told = known.reduce((end, one) => (one.station === station ? Math.max(end, one.end) : end), 0)
  return linesFrom(lines, told, run.duration).map(({ line, from, to }) => ({
    time: from,
    end: to,
    kind: 'open',
    station,
    line,
    text: words.goesOn,
  }))
}

/** Stretches of one line each from a time on; without those in which none runs. */
function linesFrom({ times, values }: Series, start: number, end: number) {
  const found: { readonly line: number; readonly from: number; to: number }[] = []
  for (let at = Math.max(countUpTo(times, start, time => time) - 1, 0); at < times.length; at++) {
    const line = values[at] ?? 0
    const from = Math.max(times[at] ?? end, start)
    const to = times[at + 1] ?? end
    const last = found.at(-1)
    if (last?.line === line && last.to === from) last.to = to
    else if (line > 0 && to > from) found.push({ line, from, to })
  }
  return found
}

/** Tasks are stretches around steps, not steps. */
function isStep(event: RunEvent): boolean {
  return event.kind !== 'task' && event.span !== null
}

function inOrder<M extends { readonly time: number }>(marks: M[]): M[] {
  return marks.sort((a, b) => a.time - b.time)
}
