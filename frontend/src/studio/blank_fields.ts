/** Fields of a step that have to be filled in and are blank. */
import type { PlaceChoice, TaskChoice } from '../wire/messages'
import { type ChosenStep, isName, splitNumbers } from './chosen_step'

export interface BlankField {
  /** `point 0`, `value 1` and so on. */
  readonly field: string
  /** What people call it. */
  readonly word: string
}

/** A point of which numbers are being typed is blank until it has three. */
export function blankFields(
  step: ChosenStep,
  task: TaskChoice,
  places: readonly PlaceChoice[],
): readonly BlankField[] {
  const passed = task.parameters.filter(one => !one.told)
  const points = passed.filter(one => one.kind === 'location')
  const values = passed.filter(one => one.kind !== 'location')
  const counts = step.points.map(one => places.find(place => place.text === one)?.count ?? 1)
  const covered = (k: number) => counts.slice(0, k).reduce((sum, one) => sum + one, 0) > k
  const blank = (typed: string) =>
    typed.trim() === '' ||
    (!isName(typed) && splitNumbers(typed).filter(Boolean).length < 3 && splitNumbers(typed).some(isNumeric))
  return [
    ...points.flatMap((one, k) =>
      blank(step.points[k] ?? '') && !one.default && !covered(k)
        ? [{ field: `point ${k}`, word: one.word }]
        : [],
    ),
    ...values.flatMap((one, k) =>
      !(step.values[k] ?? '').trim() && !one.default ? [{ field: `value ${k}`, word: one.word }] : [],
    ),
  ]
}

function isNumeric(typed: string): boolean {
  return typed !== '' && Number.isFinite(Number(typed))
}
