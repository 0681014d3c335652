/** Enter: the line breaks at the cursor, and the next one begins at its depth. */
import { getIndentation, IndentContext, indentString } from '@codemirror/language'
import { countColumn, EditorSelection, type StateCommand, Text } from '@codemirror/state'
import { endOfText } from './brackets'

/**
 * Break the line. The closing bracket behind the cursor goes to the new line, where its contents go on and typing it
 * goes over it. The closing quote of a text stays, since a text ends on its line. Blanks before the break on an empty
 * line, and those behind it, go.
 */
export const breakLine: StateCommand = ({ state, dispatch }) => {
  if (state.readOnly) return false
  const broken = state.changeByRange(range => {
    const kept = range.empty ? endOfText(state, range.from).length : 0
    const start = range.from + kept
    const end = range.to + kept
    const line = state.doc.lineAt(start)
    const last = state.doc.lineAt(end)
    const before = line.text.slice(0, start - line.from)
    const behind = last.text.slice(end - last.from)
    const depth = getIndentation(new IndentContext(state, { simulateBreak: start }), start)
    const blank = /^\s*/.exec(line.text)?.[0] ?? ''
    const indent = indentString(state, depth ?? countColumn(blank, state.tabSize))
    const from = before.trim() === '' ? line.from : start
    const to = end + (behind.length - behind.trimStart().length)
    return {
      changes: { from, to, insert: Text.of(['', indent]) },
      range: EditorSelection.cursor(from + 1 + indent.length),
    }
  })
  dispatch(state.update(broken, { scrollIntoView: true, userEvent: 'input' }))
  return true
}
