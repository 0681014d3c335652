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
/** Closes the innermost block where nothing else stands on its line. */
const END = /^\s*end\s*\.?\s*(?:#.*|\/\/.*)?$/i
const OPENERS = new Set(Object.values(CLOSERS))
const HEAD = /^\s*(?:\d+\.\s+)?([A-Za-z_]\w*)/
const ONE_LINE_IF = /\bthen\s+[^\s#/]/i

function headOf(line: string): string {
  return HEAD.exec(line)?.[1]?.toLowerCase() ?? ''
}

function opens(head: string, line: string): boolean {
  return OPENERS.has(head) && !(head === 'if' && ONE_LINE_IF.test(line))
}

/** Number of the line that closes the block opened on line `number`; null where it opens none. */
export function closingLine(doc: Text, number: number): number | null {
  const first = doc.line(number).text
  const opener = headOf(first)
  if (!opens(opener, first)) return null
  const open = [opener]
  for (let at = number + 1; at <= doc.lines; at += 1) {
    const { text } = doc.line(at)
    const head = headOf(text)
    if (head === 'task' && opener !== 'task') return null
    if (opens(head, text)) open.push(head)
    else if (END.test(text)) open.pop()
    else if (open.includes(CLOSERS[head] ?? '')) open.length = open.lastIndexOf(CLOSERS[head] ?? '')
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
