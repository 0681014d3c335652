/** Which results of lines are those of the text as it stands: what they hang on is compared with the run. */
import type { LineContent } from './line_contents'
import type { StudioState, StudioStore } from './state'

export const LINE_RESULTS = ['valid', 'pending', 'stale'] as const
export type LineResult = (typeof LINE_RESULTS)[number]

/** By line, from 1. */
export type LineResults = ReadonlyMap<number, LineResult>

export const NO_RESULTS: LineResults = new Map()

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

const NO_LINES = [] as const

/** What the results of a document follow from. */
export function causesOf({ lines, results, changed, status }: StudioState, document: string) {
  const isComing = changed || status?.state === 'waiting' || status?.state === 'running'
  return [lines[document] ?? NO_LINES, results[document], isComing ? 'run' : 'nothing'] as const
}

/** Tell the results of a document now and whenever they change; return how to end that. */
export function onLineResults(
  store: StudioStore,
  document: string,
  tell: (results: LineResults) => void,
): () => void {
  let known: readonly unknown[] = []
  const look = () => {
    const causes = causesOf(store.getState(), document)
    if (causes.every((cause, place) => cause === known[place])) return
    known = causes
    tell(lineResults(...causes))
  }
  look()
  return store.subscribe(look)
}

/** How many lines have each result. */
export function countsOf(results: LineResults): Readonly<Record<LineResult, number>> {
  const counts = { valid: 0, pending: 0, stale: 0 }
  for (const result of results.values()) counts[result] += 1
  return counts
}
