/** Marks that a view shows; what is read under the pointer stays open while its marks stay the same. */
import {
  type Diagnostic,
  forEachDiagnostic,
  linter,
  setDiagnostics,
  setDiagnosticsEffect,
} from '@codemirror/lint'
import type { EditorState, Extension, Transaction } from '@codemirror/state'
import type { EditorView } from '@codemirror/view'

interface Placed {
  readonly mark: Diagnostic
  readonly from: number
  readonly to: number
}

/**
 * How many marks were put into a view the last time. One whose text is gone is no longer found, but its sign beside
 * the line is still there.
 */
const put = new WeakMap<EditorView, number>()

/** Show these marks in the place of those shown now; equal ones stay the same objects. */
export function putMarks(view: EditorView, marks: readonly Diagnostic[]): void {
  const before = placedMarks(view.state)
  const after = marks.map(mark => before.find(one => isSame(one, mark))?.mark ?? mark)
  const isWhole = before.length === (put.get(view) ?? 0)
  if (isWhole && after.length === before.length && before.every(({ mark }) => after.includes(mark))) return
  put.set(view, after.length)
  view.dispatch(setDiagnostics(view.state, after))
}

/** The marks that `isWanted` of a state, where they are now. */
export function marksShown(state: EditorState, isWanted: (mark: Diagnostic) => boolean): Diagnostic[] {
  return placedMarks(state).flatMap(({ mark, from, to }) => {
    if (!isWanted(mark)) return []
    return mark.from === from && mark.to === to ? [mark] : [{ ...mark, from, to }]
  })
}

/** Other marks elsewhere do not close what is read about a place. */
export function staysOpen(): Extension {
  return linter(null, { hideOn: isChangedAt })
}

/** Whether a transaction changes the marks at a place; null where it sets none or changes the text. */
export function isChangedAt(transaction: Transaction, from: number, to: number): boolean | null {
  if (transaction.docChanged) return null
  const set = transaction.effects.find(one => one.is(setDiagnosticsEffect))
  if (!set) return null
  const isThere = (one: { from: number; to: number }) => one.from <= to && one.to >= from
  const before = placedMarks(transaction.startState).filter(isThere)
  const after = (set.value as readonly Diagnostic[]).filter(isThere)
  return !(before.length === after.length && before.every(({ mark }) => after.includes(mark)))
}

function placedMarks(state: EditorState): readonly Placed[] {
  const marks: Placed[] = []
  forEachDiagnostic(state, (mark, from, to) => marks.push({ mark, from, to }))
  return marks
}

function isSame({ mark, from, to }: Placed, other: Diagnostic): boolean {
  return (
    from === other.from &&
    to === other.to &&
    mark.from === from &&
    mark.to === to &&
    mark.severity === other.severity &&
    mark.source === other.source &&
    mark.message === other.message &&
    mark.markClass === other.markClass &&
    (mark.actions ?? []).map(one => one.name).join() === (other.actions ?? []).map(one => one.name).join()
  )
}
