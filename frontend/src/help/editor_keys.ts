/** The keys of the text editor, for the key sheet; `editor_keys.test.ts` holds them against what acts. */
import { helpWords as words } from './words'

export const EDITOR_KEYS: readonly (readonly [keys: readonly string[], title: string])[] = [
  [['F12'], words.editor.definition],
  [['Shift+F12'], words.editor.references],
  [['F2'], words.editor.rename],
  [['Ctrl+Shift+Space'], words.editor.signature],
  [['Ctrl+.'], words.editor.actions],
  [['Ctrl+Shift+[', 'Ctrl+Shift+]'], words.editor.fold],
]
