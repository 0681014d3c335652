/** A taught pose on an empty line: a whole move, as deep as the lines around, and an empty line for the next one. */
import type { EditorState, TransactionSpec } from '@codemirror/state'

/** The change that writes a move to a location where the cursor stands alone on an empty line; null elsewhere. */
export function moveOnEmptyLine({ doc, selection }: EditorState, location: string): TransactionSpec | null {
  const { main } = selection
  const line = doc.lineAt(main.head)
  if (!main.empty || line.text.trim() !== '') return null
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
