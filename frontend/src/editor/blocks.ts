/** Blocks of a task text: which line closes what which line opens, for folding. */
import type { Text } from '@codemirror/state'

const CLOSERS: Readonly<Record<string, string>> = {
  endp: 'task',
  endtask: 'task',
  endr: 'repeat',
  until: 'repeat',
  endif: 'if',
  endw: 'while',
  endf: 'for',
  endwith: 'with',
}
const OPENERS = new Set(Object.values(CLOSERS))
const HEAD = /^\s*(?:\d+\.\s+)?([A-Za-z_]\w*)/
const ONE_LINE_IF = /\bthen\s+[^\s#/]/i

function headOf(line: string): string {
  return HEAD.exec(line)?.[1]?.toLowerCase() ?? ''
}

/** Number of the line that closes the block opened on line `number`; null where it opens none. */
export function closingLine(doc: Text, number: number): number | null {
  const first = doc.line(number).text
  const opener = headOf(first)
  if (!OPENERS.has(opener) || (opener === 'if' && ONE_LINE_IF.test(first))) return null
  let depth = 1
  for (let at = number + 1; at <= doc.lines; at += 1) {
    const { text } = doc.line(at)
    const head = headOf(text)
    if (head === 'task' && opener !== 'task') return null
    if (head === opener && !(head === 'if' && ONE_LINE_IF.test(text))) depth += 1
    if (CLOSERS[head] === opener) depth -= 1
    if (depth === 0) return at
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
