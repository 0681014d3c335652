import { type Diagnostic, lintGutter, setDiagnosticsEffect } from '@codemirror/lint'
import { EditorState, type Transaction, type TransactionSpec } from '@codemirror/state'
import type { EditorView } from '@codemirror/view'
import { expect, test } from 'vitest'
import { isChangedAt, marksShown, putMarks } from './shown_marks'

const TEXT = 'Cary here, there\nlin here'
const FIX: Diagnostic = {
  from: 0,
  to: 4,
  severity: 'error',
  message: 'Task not defined',
  source: 'T1',
  actions: [{ name: 'Change to “Carry”', apply: () => undefined }],
}
const FAR: Diagnostic = { from: 17, to: 25, severity: 'warning', message: 'too far', source: 'M1' }

/** A view without a page: what is dispatched to it is its next state. */
class Shown {
  state = EditorState.create({ doc: TEXT, extensions: [lintGutter()] })
  readonly sent: Transaction[] = []

  dispatch(spec: TransactionSpec): void {
    const transaction = this.state.update(spec)
    this.sent.push(transaction)
    this.state = transaction.state
  }

  put(...marks: Diagnostic[]): void {
    putMarks(this as unknown as EditorView, marks)
  }

  get marks(): readonly Diagnostic[] {
    return marksShown(this.state, () => true)
  }
}

test('equal marks are not set again and stay the same objects', () => {
  const view = new Shown()
  view.put(FIX, FAR)
  view.put({ ...FAR }, { ...FIX })
  expect(view.sent).toHaveLength(1)
  view.put({ ...FIX })
  expect(view.sent).toHaveLength(2)
  expect(view.marks).toEqual([FIX])
  expect(view.marks[0]).toBe(FIX)
})

test('only a change of the marks at a place closes what is read there', () => {
  const view = new Shown()
  view.put(FIX)
  view.put({ ...FIX }, FAR)
  const [, far] = view.sent as [Transaction, Transaction]
  expect(far.effects.some(one => one.is(setDiagnosticsEffect))).toBe(true)
  expect(isChangedAt(far, 0, 4)).toBe(false)
  expect(isChangedAt(far, 17, 25)).toBe(true)
  view.put({ ...FIX, message: 'another' }, FAR)
  expect(isChangedAt(view.sent[2] as Transaction, 0, 4)).toBe(true)
  expect(isChangedAt(view.sent[2] as Transaction, 17, 25)).toBe(false)
})

test('typing and other changes are judged as ever', () => {
  const view = new Shown()
  view.put(FIX)
  view.dispatch({ changes: { from: 0, insert: 'x' } })
  view.dispatch({ selection: { anchor: 2 } })
  expect(view.sent.slice(1).map(one => isChangedAt(one, 0, 4))).toEqual([null, null])
})

test('marks move with the text and are new marks from there', () => {
  const view = new Shown()
  view.put(FIX)
  view.dispatch({ changes: { from: 0, insert: '  ' } })
  expect(view.marks.map(one => [one.from, one.to])).toEqual([[2, 6]])
  view.put({ ...FIX, from: 2, to: 6 })
  expect(view.marks[0]).not.toBe(FIX)
  expect(view.marks.map(one => [one.from, one.to])).toEqual([[2, 6]])
})

test('a mark whose text is gone leaves no sign beside the line', () => {
  const view = new Shown()
  view.put(FAR)
  view.dispatch({ changes: { from: 17, to: 25 } })
  expect(view.marks).toEqual([])
  view.put()
  const last = view.sent.at(-1) as Transaction
  expect(last.effects.some(one => one.is(setDiagnosticsEffect))).toBe(true)
  view.put()
  expect(view.sent).toHaveLength(3)
})
