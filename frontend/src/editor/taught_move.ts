/** A taught pose as a whole move: on an empty line, or before or behind the line at whose end the cursor stands. */
import type { EditorState, TransactionSpec } from '@codemirror/state'

/** Behind this the pose itself is wanted: a word that takes a target, an operator, an opening parenthesis. */
const OPEN = /(?:^|[\s(])(?:mov|lin|circ|spline|via|to|from|in|and|or|not)\s*$|[=(,+*/-]\s*$/

/** The change that writes a move to a location at the cursor; null where the pose itself belongs there. */
export function taughtMove(state: EditorState, location: string): TransactionSpec | null {
  const { doc, selection } = state
  const { main } = selection
  const line = doc.lineAt(main.head)
  if (!main.empty) return null
  if (line.text.trim() === '') return onEmptyLine(state, location)
  const indent = /^\s*/.exec(line.text)?.[0] ?? ''
  const before = line.text.slice(0, main.head - line.from)
  const behind = line.text.slice(main.head - line.from)
  const move = `${indent}mov ${location}`
  if (before.trim() === '') {
    return {
      changes: { from: line.from, insert: `${move}\n` },
      selection: { anchor: line.from + move.length },
    }
  }
  if (behind.trim() !== '' || OPEN.test(before)) return null
  const at = line.to + 1 + move.length
  return { changes: { from: line.to, insert: `\n${move}` }, selection: { anchor: at } }
}

function onEmptyLine({ doc, selection }: EditorState, location: string): TransactionSpec {
  const line = doc.lineAt(selection.main.head)
  const indent = line.text || deepest(depthFrom(-1), depthFrom(1))
  const insert = `${indent}mov ${location}`
  const next = line.number < doc.lines ? doc.line(line.number + 1) : null
  const isFree = next !== null && next.text.trim() === ''
  const change = { from: line.from, to: line.to, insert: isFree ? insert : `${insert}\n${indent}` }
  const moved = line.from + change.insert.length
  return { changes: change, selection: { anchor: isFree ? moved + 1 + next.length : moved } }

  /** White space before the nearest line with words, up or down. */
  function depthFrom(step: 1 | -1): string {
    for (let at = line.number + step; at >= 1 && at <= doc.lines; at += step) {
      const { text } = doc.line(at)
      if (text.trim()) return /^\s*/.exec(text)?.[0] ?? ''
    }
    return ''
  }
}

function deepest(above: string, below: string): string {
  return below.length > above.length ? below : above
}
