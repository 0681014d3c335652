/** What is pasted or dropped into a text: halves of characters and byte order marks stay out, as no file keeps them. */
import { EditorView } from '@codemirror/view'

const HALVES = /[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]/g
const REPLACEMENT = '\ufffd'

export function keepable(text: string): string {
  return text.replaceAll('\ufeff', '').replace(HALVES, REPLACEMENT)
}

export const pasted = EditorView.clipboardInputFilter.of(keepable)
