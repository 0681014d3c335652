/** Findings of all sources in one list: the language server, compiling, the run, the scene. */
import type { Finding } from '../run/run'

export type Severity = Finding['severity']

export interface Problem {
  /** Name of the document, empty where the finding belongs to none. */
  readonly document: string
  /** Name of the file that it is in, where that is no document, such as a robot file; else absent. */
  readonly file?: string
  /** From 1; 0 where the finding has no place. */
  readonly line: number
  readonly column: number
  readonly endLine: number
  readonly endColumn: number
  readonly severity: Severity
  readonly code: string
  readonly message: string
  readonly hint: string
  /** Simulated time [s] at which it arose, null where it has none. */
  readonly time: number | null
  /** From where it likely follows; absent where it stands alone. */
  readonly follows?: { readonly document: string; readonly line: number }
  /** Where in the world it is [m]; absent where it has no place. */
  readonly place?: readonly [number, number, number]
}

const RANK: Readonly<Record<Severity, number>> = { error: 0, warning: 1, info: 2, hint: 3 }

/** The finding as a problem; its source is a document of the project or none. */
export function problemOf(finding: Finding, documentOf: (source: string) => string): Problem {
  const { span } = finding
  const document = span ? documentOf(span.source) : ''
  return {
    document,
    ...(span && !document ? { file: span.source.split(/[\\/]/).at(-1) ?? '' } : {}),
    line: span?.line ?? 0,
    column: span?.column ?? 0,
    endLine: span?.end_line ?? 0,
    endColumn: span?.end_column ?? 0,
    severity: finding.severity,
    code: finding.code,
    message: finding.message,
    hint: finding.hint,
    time: finding.time,
    ...(finding.place ? { place: finding.place } : {}),
    ...(finding.follows
      ? { follows: { document: documentOf(finding.follows.source), line: finding.follows.line } }
      : {}),
  }
}

/** The place of a problem with its code; without a line its words are part of it. */
function placeOf({ document, file, line, column, code, time, message }: Problem): string {
  return [document, file, line, column, code, time, line === 0 ? message : ''].join('|')
}

/**
 * Worst first, then by document and line. What two sources say of one place is listed once; one source may say
 * several things there, such as two reasons for which the arm stops.
 */
export function mergeProblems(sources: ReadonlyMap<string, readonly Problem[]>): readonly Problem[] {
  const said = new Set<string>()
  const merged: Problem[] = []
  for (const problems of sources.values()) {
    const fresh = problems.filter(problem => !said.has(placeOf(problem)))
    const unique = new Map(fresh.map(problem => [`${placeOf(problem)}|${problem.message}`, problem]))
    merged.push(...unique.values())
    for (const problem of fresh) said.add(placeOf(problem))
  }
  return merged.sort(
    (a, b) =>
      RANK[a.severity] - RANK[b.severity] ||
      a.document.localeCompare(b.document) ||
      a.line - b.line ||
      (a.time ?? 0) - (b.time ?? 0),
  )
}
