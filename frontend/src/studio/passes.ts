/** The passes of a program line through a run: when the robot had done what the line says. */
import type { Run } from '../run/run'

export interface Pass {
  /** Start and end of what the line did [s]. */
  readonly from: number
  readonly to: number
}

const KINDS = new Set(['move', 'skip', 'grip', 'release', 'wait', 'await', 'output', 'message', 'task'])

/** Passes of a line in order of time; what a line did in one go (moves of a called task) is one pass. */
export function passesOf(run: Run, isDocument: (source: string) => boolean, line: number): readonly Pass[] {
  const own: Pass[] = []
  for (const event of run.events) {
    const { span } = event
    if (!span || span.line !== line || !KINDS.has(event.kind) || !isDocument(span.source)) continue
    const pass = { from: event.time, to: event.time + event.duration }
    const last = own.at(-1)
    // A task and its first move may begin on one line at one time: the longer one stands for both.
    if (last && pass.from < last.to && pass.from >= last.from) {
      own[own.length - 1] = { from: last.from, to: Math.max(last.to, pass.to) }
    } else {
      own.push(pass)
    }
  }
  return own
}

/** Index of the pass that is under way at a time, else of the nearest one; -1 without passes. */
export function nearestPass(passes: readonly Pass[], time: number): number {
  let best = -1
  let distance = Number.POSITIVE_INFINITY
  passes.forEach((pass, at) => {
    const away = Math.max(pass.from - time, time - pass.to, 0)
    if (away < distance) {
      best = at
      distance = away
    }
  })
  return best
}
