/** Which results of lines are those of the text as it stands: what they hang on is compared with the run. */
import type { RunStatus } from '../wire/messages'

export const LINE_RESULTS = ['valid', 'pending', 'stale'] as const
export type LineResult = (typeof LINE_RESULTS)[number]

/** By line, from 1. */
export type LineResults = ReadonlyMap<number, LineResult>

export const NO_RESULTS: LineResults = new Map()

/** A line on which the robot moves, grips or waits, from 0, and what its result hangs on; empty with errors. */
export interface LineContent {
  readonly line: number
  readonly content: string
}

/** What the results of a program's lines hang on in the newest good run, by document. */
export type RunContents = RunStatus['results']

/** Whether a run is on its way that will be one of the text. */
export type Expectation = 'run' | 'nothing'

/**
 * The results of the lines of a document.
 *
 * @param lines of the document, as the language server has them
 * @param known what the lines of the newest good run hang on; undefined where it is not one of this document
 * @param coming whether a run of this text is on its way
 */
export function lineResults(
  lines: readonly LineContent[],
  known: readonly string[] | undefined,
  coming: Expectation,
): LineResults {
  if (!known) return NO_RESULTS
  const keys = new Set(known)
  const otherwise = coming === 'run' ? 'pending' : 'stale'
  const result = (content: string): LineResult => {
    if (content === '') return 'stale'
    return keys.has(content) ? 'valid' : otherwise
  }
  return new Map(lines.map(({ line, content }) => [line + 1, result(content)]))
}

/** How many lines have each result. */
export function countsOf(results: LineResults): Readonly<Record<LineResult, number>> {
  const counts = { valid: 0, pending: 0, stale: 0 }
  for (const result of results.values()) counts[result] += 1
  return counts
}
