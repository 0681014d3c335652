/** Blocks of a task text: which line closes what which line opens, for folding. */
import type { Text } from '@codemirror/state'
import { ANY, closed, opened } from './block_lines'

/** Number of the line that closes the block opened on line `number`; null where it opens none. */
export function closingLine(doc: Text, number: number): number | null {
  const opener = opened(doc.line(number).text)
  if (!opener) return null
  const open = [opener]
  for (let at = number + 1; at <= doc.lines; at += 1) {
    const { text } = doc.line(at)
    const [inner, closer] = [opened(text), closed(text)]
    if (inner === 'task' && opener !== 'task') return null
    if (inner) open.push(inner)
    else if (closer === ANY) open.pop()
    else if (open.includes(closer)) open.length = open.lastIndexOf(closer)
    if (open.length === 0) return at
  }
  return null
}

/** The stretch that folds away under a line: from its end to the end of the closing line. */
export function foldedBy(doc: Text, number: number): { readonly from: number; readonly to: number } | null {
  const last = closingLine(doc, number)
  if (last === null) return null
  const from = doc.line(number).to
  const closing = doc.line(last)
  return { from, to: closing.from + (closing.text.length - closing.text.trimStart().length) }
}
