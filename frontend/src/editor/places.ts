/** Places of the protocol in a text: line and UTF-16 unit, both from 0. */
import type { Text } from '@codemirror/state'

export interface Place {
  readonly line: number
  readonly character: number
}

export interface Edit {
  readonly range: { readonly start: Place; readonly end: Place }
  readonly newText: string
}

/** The offset of a place, null for one on no line of the text. */
export function offsetOf(doc: Text, { line, character }: Place): number | null {
  if (line >= doc.lines) return line === doc.lines && character === 0 ? doc.length : null
  const at = doc.line(line + 1)
  return Math.min(at.from + character, at.to)
}

/** Edits as changes of a text, in their order; null where one of them stands on no line of it. */
export function changesOf(
  doc: Text,
  edits: readonly Edit[],
): readonly { from: number; to: number; insert: string }[] | null {
  const changes = edits.map(({ range, newText }) => {
    const from = offsetOf(doc, range.start)
    const to = offsetOf(doc, range.end)
    return from === null || to === null ? null : { from, to, insert: newText }
  })
  return changes.every(one => one !== null) ? changes : null
}
