/** Lines of a program and the times at which they run. */
import type { Run, RunEvent } from '../run/run'

/** The steps of each line of the text that a station runs, in order of time. */
export function stepsByLine(
  run: Run,
  source: string,
  station: string,
): ReadonlyMap<number, readonly RunEvent[]> {
  const steps = new Map<number, RunEvent[]>()
  const inOrder = [...run.events].sort((a, b) => a.time - b.time)
  for (const event of inOrder) {
    if (event.kind === 'task' || event.station !== station || event.span?.source !== source) continue
    const known = steps.get(event.span.line)
    if (known) known.push(event)
    else steps.set(event.span.line, [event])
  }
  return steps
}

/** The pass to go to when a line is chosen: the first one after `time`, after the last one the first again. */
export function nextPass(steps: readonly RunEvent[], time: number): number {
  const next = steps.findIndex(step => step.time > time + 1e-6)
  return Math.max(next, 0)
}
