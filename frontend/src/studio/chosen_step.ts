/** A step as it is typed, and how its fields are read and written. */
import type { TaskStep } from '../wire/commands'

export interface ChosenStep extends TaskStep {
  /** Tells steps apart, whatever they say. */
  readonly key: number
}

/** Steps that were kept, none where they cannot be read. */
export function keptSteps(kept: unknown): readonly ChosenStep[] {
  if (!Array.isArray(kept)) return []
  const areTexts = (value: unknown) => Array.isArray(value) && value.every(one => typeof one === 'string')
  const sound = kept.every(
    one =>
      typeof one?.key === 'number' &&
      typeof one.name === 'string' &&
      areTexts(one.points) &&
      areTexts(one.values),
  )
  return sound ? kept : []
}

/** A list with one entry changed; blank entries are put in before it where it is longer. */
export function withEntry(list: readonly string[], at: number, entry: string): readonly string[] {
  return Array.from({ length: Math.max(list.length, at + 1) }, (_, k) => (k === at ? entry : (list[k] ?? '')))
}

/** `75 mm` as number and unit. */
export function splitValue(text: string): { readonly number: string; readonly unit: string } {
  const [, number = '', unit = ''] = /^\s*(\S*)\s*(.*?)\s*$/.exec(text) ?? []
  return { number, unit }
}

/** Whether a point is given by its name. */
export function isName(point: string): boolean {
  return /^[^\W\d]\w*$/.test(point)
}

/** X Y Z Pitch Roll Yaw of a point as they are typed; blank ones are not given. */
export function splitNumbers(point: string): readonly string[] {
  const words = point.includes(',')
    ? point.split(',').map(one => one.trimStart())
    : point.split(/\s+/).filter(Boolean)
  return Array.from({ length: 6 }, (_, k) => words[k] ?? '')
}

/** What is typed for one number: a comma is a decimal point, as in the fields of the jog panel; a blank in it stays. */
export function oneNumber(typed: string): string {
  return typed.trimStart().replaceAll(',', '.')
}

/** The other way: without the blank ones at the end. */
export function joinNumbers(numbers: readonly string[]): string {
  const words = numbers.map(oneNumber)
  while (words.at(-1) === '') words.pop()
  const [only = ''] = words
  // One number with a blank in it is not two.
  return words.length === 1 && /\s/.test(only) ? `${only},` : words.join(', ')
}

/** Name of a program text as the language takes it. */
export function programWord(name: string): string {
  return name.replace(/\W+/g, '_').replace(/^(?=\d)/, 'p')
}
