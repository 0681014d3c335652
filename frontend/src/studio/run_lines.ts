/** Lines of runs and findings in the texts as they are now: both belong to texts of a moment ago. */
import type { Finding } from '../run/run'
import type { RunStatus } from '../wire/messages'
import { type LineMap, lineMap, SAME_LINES } from './line_map'
import { type Problem, problemOf } from './problems'

/** Texts of a moment by document; a document that is not there is as it is now. */
export type Texts = ReadonlyMap<string, string>

export const NOW: Texts = new Map()

/** Whether a run stays the result of older texts than those of now. */
export type RunAge = RunStatus['age']

/** Whether texts of a moment, as far as they are known, are those of another one. */
export function isOfTexts(texts: Texts, others: Texts): boolean {
  return [...others].every(([document, text]) => texts.get(document) === text)
}

export interface TextSource {
  /** The newest text of a document. */
  readonly text: (document: string) => string
  readonly documentOf: (source: string) => string
}

export class RunLines {
  readonly #source: TextSource
  readonly #maps = new Map<string, { older: string; newer: string; map: LineMap }>()
  /** Texts of the run that is shown. */
  #run: Texts = NOW
  #age: RunAge = 'newest'

  constructor(source: TextSource) {
    this.#source = source
  }

  /** The run that is shown is one of these texts. */
  showRun(texts: Texts, age: RunAge = 'newest'): void {
    this.#run = texts
    this.#age = age
  }

  /** The run stays the result of an older text, which this page may never have seen. */
  get isOlder(): boolean {
    return this.#age === 'older'
  }

  /** Whether a text has changed since the run, as far as its texts are known. */
  get changed(): boolean {
    return this.isOlder || this.areChanged(this.#run)
  }

  /** Whether one of these texts has changed since. */
  areChanged(texts: Texts): boolean {
    return [...texts].some(([document, text]) => this.#source.text(document) !== text)
  }

  /** Whether the run is one of these texts, all of them. */
  isOf(texts: Texts): boolean {
    return isOfTexts(this.#run, texts)
  }

  /** Line of the run in the text of now; null where it is gone. */
  toText(document: string, line: number): number | null {
    return this.#map(document, this.#run).toNew(line)
  }

  /** A line of a source of the run, from 1, as a place in the texts of now; null where there is none. */
  place(source: string, line: number): { readonly document: string; readonly line: number } | null {
    const document = this.#source.documentOf(source)
    const there = document && line > 0 ? this.toText(document, line) : null
    return there === null ? null : { document, line: there }
  }

  /** Line of the text of now in the run; null where it is new. */
  toRun(document: string, line: number): number | null {
    return this.#map(document, this.#run).toOld(line)
  }

  /** Findings as problems of the texts of now; those of lines that are gone are gone with them. */
  problems(findings: readonly Finding[], texts: Texts): readonly Problem[] {
    const problems: Problem[] = []
    for (const finding of findings) {
      const problem = this.#causeNow(
        problemOf(finding, source => this.#source.documentOf(source)),
        texts,
      )
      const { document, line, endLine } = problem
      if (!document || line === 0) {
        problems.push(problem)
        continue
      }
      const there = this.#map(document, texts).toNew(line)
      if (there !== null) problems.push({ ...problem, line: there, endLine: endLine + there - line })
    }
    return problems
  }

  /** A problem with the line of its cause as it is now; without it where that is gone. */
  #causeNow({ follows, ...problem }: Problem, texts: Texts): Problem {
    const line = follows ? this.#map(follows.document, texts).toNew(follows.line) : null
    return follows && line !== null ? { ...problem, follows: { ...follows, line } } : problem
  }

  #map(document: string, texts: Texts): LineMap {
    const older = texts.get(document)
    if (older === undefined) return SAME_LINES
    const newer = this.#source.text(document)
    const known = this.#maps.get(document)
    if (known && known.older === older && known.newer === newer) return known.map
    const map = lineMap(older, newer)
    this.#maps.set(document, { older, newer, map })
    return map
  }
}
