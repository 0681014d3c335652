/** Enter: the line breaks at the cursor, and the next one begins at its depth. */
import { getIndentation, IndentContext, indentString } from '@codemirror/language'
import { countColumn, EditorSelection, type StateCommand, Text } from '@codemirror/state'

/**
 * Break the line. A bracket that the editor has closed stays on the line of the cursor, so that typing its end
 * goes over it; blanks before the break on an empty line, and those behind it, go.
 */
export const breakLine: StateCommand = ({ state, dispatch }) => {
  if (state.readOnly) return false
  const broken = state.changeByRange(range => {
    const line = state.doc.lineAt(range.from)
    const last = state.doc.lineAt(range.to)
    const before = line.text.slice(0, range.from - line.from)
    const behind = last.text.slice(range.to - last.from)
    const depth = getIndentation(new IndentContext(state, { simulateBreak: range.from }), range.from)
    const blank = /^\s*/.exec(line.text)?.[0] ?? ''
    const indent = indentString(state, depth ?? countColumn(blank, state.tabSize))
    const from = before.trim() === '' ? line.from : range.from
    const to = range.to + (behind.length - behind.trimStart().length)
    return {
      changes: { from, to, insert: Text.of(['', indent]) },
      range: EditorSelection.cursor(from + 1 + indent.length),
    }
  })
  dispatch(state.update(broken, { scrollIntoView: true, userEvent: 'input' }))
  return true
}
