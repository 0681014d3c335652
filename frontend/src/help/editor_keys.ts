/** Keys of the text editor beside those of the Edit menu, for the key sheet; `editor_keys.test.ts` holds them against what acts. */
import { helpWords as words } from './words'

export const EDITOR_KEYS: readonly (readonly [keys: readonly string[], title: string])[] = [
  [['F3', 'Shift+F3'], words.editor.again],
  [['Ctrl+Shift+[', 'Ctrl+Shift+]'], words.editor.fold],
]
