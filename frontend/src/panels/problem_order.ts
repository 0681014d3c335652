/** Problems in the order of the texts, for going from one to the next. */
import type { Problem } from '../studio/problems'

export interface TextPlace {
  readonly document: string
  readonly line: number
  readonly column: number
}

function compare(a: TextPlace, b: TextPlace): number {
  return a.document.localeCompare(b.document) || a.line - b.line || a.column - b.column
}

/** The problem after (or before) a place, going round at the ends; undefined where no problem has a place. */
export function neighbour(
  problems: readonly Problem[],
  place: TextPlace,
  direction: 'next' | 'previous',
): Problem | undefined {
  const placed = problems.filter(one => one.document !== '' && one.line > 0).sort(compare)
  if (direction === 'next') return placed.find(one => compare(one, place) > 0) ?? placed[0]
  return placed.filter(one => compare(one, place) < 0).at(-1) ?? placed.at(-1)
}

/** Problems that hold all words of a query. */
export function matching(problems: readonly Problem[], query: string): readonly Problem[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean)
  const textOf = (one: Problem) =>
    `${one.severity} ${one.code} ${one.document} ${one.message} ${one.hint}`.toLowerCase()
  return words.length === 0
    ? problems
    : problems.filter(one => words.every(word => textOf(one).includes(word)))
}
