/** Problems that are one for the reader: the same finding on the same line, once for every pass of it. */
import type { Problem } from './problems'

export interface ProblemGroup {
  /** What the row says: the one that came first. */
  readonly first: Problem
  /** All of them; those with a time in its order. */
  readonly all: readonly Problem[]
}

/** Groups in the order in which their first members stand. */
export function grouped(problems: readonly Problem[]): readonly ProblemGroup[] {
  const groups = new Map<string, Problem[]>()
  for (const problem of problems) {
    const key = keyOf(problem)
    const group = groups.get(key)
    if (group) group.push(problem)
    else groups.set(key, [problem])
  }
  return [...groups.values()].map(found => {
    const all = found.sort((a, b) => (a.time ?? -1) - (b.time ?? -1))
    return { first: all[0] as Problem, all }
  })
}

/** Findings of one kind on one line may differ in their numbers, and without a line or a code in nothing. */
function keyOf({ document, line, severity, code, message, follows }: Problem): string {
  const words = line > 0 && code ? message.replace(/-?\d+(\.\d+)?(e-?\d+)?/g, '0') : message
  return [document, line, severity, code, follows?.line, words].join('|')
}

/** Groups in their order, but what likely follows from a line stands behind what is found there. */
export function belowCauses(groups: readonly ProblemGroup[]): readonly ProblemGroup[] {
  const placed = groups.filter(one => !one.first.follows)
  for (const one of groups) {
    const { follows } = one.first
    if (!follows) continue
    const isOfCause = ({ first }: ProblemGroup) => {
      const place = first.follows ?? first
      return place.document === follows.document && place.line === follows.line
    }
    const last = placed.filter(isOfCause).at(-1)
    placed.splice(last ? placed.indexOf(last) + 1 : placed.length, 0, one)
  }
  return placed
}

/** The member to go to next from a time: the one after it, else the first. */
export function nextOf(group: ProblemGroup, time: number): Problem {
  // A cursor that stands on one of them is a rounding away from it.
  return group.all.find(one => one.time !== null && one.time > time + 1e-6) ?? group.first
}
