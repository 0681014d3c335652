/** Which units the user wants to see. Numbers inside are SI whatever is chosen. */

export const LENGTHS = ['mm', 'm', 'in'] as const
export const ANGLES = ['deg', 'rad'] as const

export interface UnitChoice {
  readonly length: (typeof LENGTHS)[number]
  readonly angle: (typeof ANGLES)[number]
}

export const METRIC: UnitChoice = { length: 'mm', angle: 'deg' }

let chosen = METRIC
const listeners = new Set<() => void>()

export function units(): UnitChoice {
  return chosen
}

export function setUnits(next: UnitChoice): void {
  if (next.length === chosen.length && next.angle === chosen.angle) return
  chosen = next
  for (const listener of [...listeners]) listener()
}

/** Hear of another choice. Returns the way to stop that. */
export function onUnits(listener: () => void): () => void {
  listeners.add(listener)
  return () => listeners.delete(listener)
}
