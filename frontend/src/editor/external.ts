/** Text that comes from elsewhere than the keyboard: an editor takes it over with the smallest changes. */
import { Annotation, type Text, type TransactionSpec } from '@codemirror/state'
import { replacements } from './replacement'

/** Marks a change that the text's owner made: it is not told of it. */
export const External = Annotation.define<true>()

/** The changes that make a document say another text, null where it does; cursor and marks go with their lines. */
export function takenOver(doc: Text, text: string): TransactionSpec | null {
  const changes = replacements(doc.toString(), text.replace(/\r\n?/g, '\n'))
  return changes.length > 0 ? { changes: [...changes], annotations: External.of(true) } : null
}
