/** What the language server finds, as marks of a view and as problems of the page. */
import type { Action, Diagnostic } from '@codemirror/lint'
import type { Text } from '@codemirror/state'
import type { EditorView } from '@codemirror/view'
import type { Problem, Severity } from '../studio/problems'

export interface WirePosition {
  readonly line: number
  readonly character: number
}

export interface WireRange {
  readonly start: WirePosition
  readonly end: WirePosition
}

export interface WireDiagnostic {
  readonly range: WireRange
  readonly severity?: number
  readonly code?: string
  readonly message: string
  readonly data?: {
    readonly hint?: string
    /** Line of the finding of which this one is a further place. */
    readonly firstLine?: number
    readonly fix?: { readonly title: string; readonly range: WireRange; readonly newText: string }
  }
}

export interface Published {
  readonly uri: string
  readonly version?: number
  readonly diagnostics: readonly WireDiagnostic[]
}

const SEVERITIES: readonly Severity[] = ['error', 'error', 'warning', 'info', 'hint']

function severityOf(found: WireDiagnostic): Severity {
  return SEVERITIES[found.severity ?? 1] ?? 'error'
}

/** Offset of a place of the protocol; places beyond the text are its end. */
function offsetOf(doc: Text, place: WirePosition): number {
  if (place.line >= doc.lines) return doc.length
  const line = doc.line(place.line + 1)
  return Math.min(line.from + place.character, line.to)
}

/** Marks for a view whose document is `doc`; `map` leads from there to what the view shows now. */
export function marksOf(
  published: readonly WireDiagnostic[],
  doc: Text,
  map: (offset: number) => number,
): readonly Diagnostic[] {
  return published.map(found => {
    const from = map(offsetOf(doc, found.range.start))
    const to = Math.max(map(offsetOf(doc, found.range.end)), from)
    const mark = { from, to, severity: severityOf(found), message: found.message, source: found.code ?? '' }
    const actions = actionsOf(found)
    return actions.length > 0 ? { ...mark, actions } : mark
  })
}

function actionsOf(found: WireDiagnostic): Action[] {
  const fix = found.data?.fix
  if (!fix || !same(fix.range, found.range)) return []
  const apply = (view: EditorView, from: number, to: number) =>
    view.dispatch({
      changes: { from, to, insert: fix.newText },
      selection: { anchor: from + fix.newText.length },
      userEvent: 'input.fix',
    })
  return [{ name: fix.title.replace(/`([^`]*)`/g, '“$1”'), apply }]
}

function same(a: WireRange, b: WireRange): boolean {
  return (
    a.start.line === b.start.line &&
    a.start.character === b.start.character &&
    a.end.line === b.end.line &&
    a.end.character === b.end.character
  )
}

/** The findings of a document for the list of problems, each mistake once; a hint stands apart from its message there. */
export function problemsOf(published: readonly WireDiagnostic[], document: string): readonly Problem[] {
  const mistakes = published.filter(found => found.data?.firstLine === undefined)
  return mistakes.map(found => {
    const hint = found.data?.hint ?? ''
    const tail = hint ? `\n${hint}` : ''
    const message =
      tail && found.message.endsWith(tail) ? found.message.slice(0, -tail.length) : found.message
    return {
      document,
      line: found.range.start.line + 1,
      column: found.range.start.character + 1,
      endLine: found.range.end.line + 1,
      endColumn: found.range.end.character + 1,
      severity: severityOf(found),
      code: found.code ?? '',
      message,
      hint,
      time: null,
    }
  })
}
