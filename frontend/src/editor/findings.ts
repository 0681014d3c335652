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
    const actions = actionsOf(found, doc)
    return actions.length > 0 ? { ...mark, actions } : mark
  })
}

/** The fix of a finding; one of more than the marked text is made where that text still stands. */
function actionsOf(found: WireDiagnostic, doc: Text): Action[] {
  const fix = found.data?.fix
  if (!fix) return []
  const [start, end] = [offsetOf(doc, fix.range.start), offsetOf(doc, fix.range.end)]
  const before = start - offsetOf(doc, found.range.start)
  const behind = end - offsetOf(doc, found.range.end)
  const old = doc.sliceString(start, end)
  const apply = (view: EditorView, from: number, to: number) => {
    const place = { from: from + before, to: to + behind }
    if ((before || behind) && view.state.sliceDoc(place.from, place.to) !== old) return
    view.dispatch({
      changes: { ...place, insert: fix.newText },
      selection: { anchor: place.from + fix.newText.length },
      userEvent: 'input.fix',
    })
  }
  return [{ name: fix.title.replace(/`([^`]*)`/g, '“$1”'), apply }]
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
