import { EditorState } from '@codemirror/state'
import { expect, test } from 'vitest'
import { taughtMove } from './taught_move'

/** A text after teaching `A` where `|` stands, with the cursor as `|`; null where it is no line for a move. */
function taught(text: string): string | null {
  const at = text.indexOf('|')
  const state = EditorState.create({ doc: text.replace('|', ''), selection: { anchor: at } })
  const change = taughtMove(state, 'A')
  if (!change) return null
  const after = state.update(change).state
  const { head } = after.selection.main
  return `${after.sliceDoc(0, head)}|${after.sliceDoc(head)}`
}

test('a move takes an empty line, and the next one follows it', () => {
  expect(taught('mov home\n|')).toBe('mov home\nmov A\n|')
  expect(taught('mov home\nmov A\n|\nmov b')).toBe('mov home\nmov A\nmov A\n|\nmov b')
  expect(taught('|\n\nmov b')).toBe('mov A\n|\nmov b')
})

test('it is as deep as the block that it stands in', () => {
  expect(taught('task T\n|\n  open\nendp')).toBe('task T\n  mov A\n  |\n  open\nendp')
  expect(taught('task T\n  open\n|\nendp')).toBe('task T\n  open\n  mov A\n  |\nendp')
  expect(taught('task T\n  open\nendp\n|\nT')).toBe('task T\n  open\nendp\nmov A\n|\nT')
  expect(taught('repeat 2\n    |\nendr')).toBe('repeat 2\n    mov A\n    |\nendr')
})

test('beside a whole line it is a line of its own', () => {
  expect(taught('mov home|')).toBe('mov home\nmov A|')
  expect(taught('|mov home')).toBe('mov A|\nmov home')
  expect(taught('task T\n  open|\nendp')).toBe('task T\n  open\n  mov A|\nendp')
  expect(taught('  |lin b')).toBe('  mov A|\n  lin b')
})

test('where a target is missing the pose itself belongs', () => {
  for (const text of ['mov |', '  lin |', 'circ via |', 'q = |', 'T (|', 'T a, |', 'mov |speed 20 %']) {
    expect(taught(text)).toBeNull()
  }
})
