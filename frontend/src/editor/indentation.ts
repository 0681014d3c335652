/** Lines of a task text keep their depth as they are typed: behind Enter, and at closing words. */
import { getIndentUnit, type IndentContext, indentService, indentString } from '@codemirror/language'
import {
  type ChangeSpec,
  countColumn,
  EditorState,
  type Extension,
  type Transaction,
} from '@codemirror/state'
import { kindOf } from './block_lines'
import { depthOf, type Row } from './depth'

const TASK = /^\s*(?:\d+\.\s+)?task\b/i
/** Typing and deleting; what is pasted, dropped or taken back stays as it is. */
const TYPED = ['input.type', 'input.complete', 'delete.backward', 'delete.forward']

/** The lines above line `number` (from 1), from the header of the nearest task on. */
function rowsAbove(
  state: EditorState,
  number: number,
  indentOf: (line: { from: number; text: string }) => number,
) {
  const rows: Row[] = []
  for (let at = number - 1; at >= 1; at -= 1) {
    const line = state.doc.line(at)
    rows.push({ text: line.text, indent: indentOf(line) })
    if (TASK.test(line.text)) break
  }
  return rows.reverse()
}

function columns(state: EditorState, text: string): number {
  return countColumn(text, state.tabSize, text.search(/\S|$/))
}

/** Where the line at a place begins, or the part of a line behind a break that is being made there. */
function indentAt(context: IndentContext, place: number): number {
  const { state } = context
  const line = state.doc.lineAt(place)
  const isBroken = context.simulatedBreak === place
  const before = isBroken ? line.text.slice(0, place - line.from) : ''
  const text = isBroken ? line.text.slice(place - line.from) : line.text
  if (isBroken && before.trim() === '' && text.trim() !== '') return columns(state, line.text)
  const rows = rowsAbove(state, line.number, one => context.lineIndent(one.from, -1))
  if (isBroken) rows.push({ text: before, indent: columns(state, before) })
  return depthOf(rows, text.trimStart(), context.unit)
}

/** The changes that move lines whose first word has become, or is no longer, one that stands elsewhere. */
function moved(typed: Transaction): ChangeSpec[] {
  const { startState, newDoc } = typed
  if (newDoc.lines !== startState.doc.lines) return []
  const changes: ChangeSpec[] = []
  const seen = new Set<number>()
  for (const { head } of typed.newSelection.ranges) {
    const line = newDoc.lineAt(head)
    const old = startState.doc.line(line.number)
    if (seen.has(line.number) || kindOf(old.text) === kindOf(line.text)) continue
    seen.add(line.number)
    const unit = getIndentUnit(startState)
    const rows = rowsAbove(startState, line.number, one => columns(startState, one.text))
    const [was, is] = [old.text, line.text].map(text => depthOf(rows, text.trimStart(), unit))
    if (is === undefined || is === was || columns(startState, line.text) !== was) continue
    const blank = line.text.length - line.text.trimStart().length
    changes.push({ from: line.from, to: line.from + blank, insert: indentString(startState, is) })
  }
  return changes
}

const stepping = EditorState.transactionFilter.of(typed => {
  if (!typed.docChanged || !TYPED.some(event => typed.isUserEvent(event))) return typed
  const changes = moved(typed)
  return changes.length > 0 ? [typed, { changes, sequential: true }] : typed
})

export function indentation(): Extension {
  return [indentService.of(indentAt), stepping]
}
