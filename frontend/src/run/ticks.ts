/** Round times for a scale. */

const STEPS = [1, 2, 5] as const

/** The round distance of ticks of which two are at least `room` wide [s]; `perSecond` is the width of a second. */
export function tickStep(perSecond: number, room: number): number {
  const least = room / perSecond
  if (!(least > 0) || !Number.isFinite(least)) return Number.POSITIVE_INFINITY
  const power = 10 ** Math.floor(Math.log10(least))
  for (const step of STEPS) if (step * power >= least * (1 - 1e-9)) return step * power
  return 10 * power
}

/** Multiples of a step between two times. */
export function ticks(from: number, to: number, step: number): readonly number[] {
  if (!Number.isFinite(step) || step <= 0) return []
  const made: number[] = []
  for (let n = Math.ceil(from / step - 1e-9) + 0; n * step <= to + 1e-9 * step; n++) made.push(n * step + 0)
  return made
}

/** A tick as it is written: no more decimals than its step needs. */
export function tickLabel(time: number, step: number): string {
  return time.toFixed(Math.max(0, Math.ceil(-Math.log10(step) - 1e-9)))
}
