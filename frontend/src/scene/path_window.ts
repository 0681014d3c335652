/** How much of the tool's path is drawn at a time: the last seconds and what comes next, or all of it. */
import type { PathShown, PathWindow } from './settings'

/** The last seconds of the path that stay in sight [s]. */
export const RECENT = 3

/** A stretch of time in which the robot moves [s]. */
export interface Move {
  readonly time: number
  readonly duration: number
}

const ALL = { from: Number.NEGATIVE_INFINITY, to: Number.POSITIVE_INFINITY }

/** The window at a time [s]; `moves` in order of time, none where nobody knows what comes. */
export function pathWindow(shown: PathShown, time: number, moves: readonly Move[]): PathWindow {
  if (shown === 'all') return { ...ALL, until: time }
  return { from: time - RECENT, until: time, to: nextEnd(moves, time) }
}

/** The end of the first move that is yet to begin, so that the rest of the present one is in sight, too [s]. */
export function nextEnd(moves: readonly Move[], time: number): number {
  let [low, high] = [0, moves.length]
  while (low < high) {
    const middle = (low + high) >> 1
    if ((moves[middle]?.time ?? 0) < time) low = middle + 1
    else high = middle
  }
  const next = moves[low] ?? moves.at(-1)
  return next ? Math.max(time, next.time + next.duration) : time
}

interface Happening extends Move {
  readonly kind: string
  readonly station: string
}

/** What of a run's events moves the robot of a station, in order of time. */
export function movesAmong(events: readonly Happening[], of: string): readonly Move[] {
  return events
    .filter(({ kind, duration, station }) => kind === 'move' && duration > 0 && station === of)
    .sort((a, b) => a.time - b.time)
}
