/** Values that a field takes, and what is said of others. */
import type { Parsed } from './parse'

export interface Range {
  /** [m | rad] */
  readonly lower: number
  readonly upper: number
  readonly said: string
}

/** An end of a range may be typed as it is shown: rounded [m | rad]. */
const ROUNDING = 1e-4

/** What was typed, within a range; a mistake outside of it. A lower end that is itself so small is exact. */
export function inRange(parsed: Parsed, range: Range | undefined): Parsed {
  if ('mistake' in parsed || !range) return parsed
  const { lower, upper, said } = range
  const below = lower > 0 ? Math.min(ROUNDING, lower / 10) : ROUNDING
  const isOutside = parsed.value < lower - below || parsed.value > upper + ROUNDING
  return isOutside ? { mistake: said } : { value: Math.min(Math.max(parsed.value, lower), upper) }
}
