/** What can be done in the text editor: menu, palette, key sheet and the editor's own keys are made of this table. */
import type { editWords as titles } from '../text/edit'

export type EditAction = keyof typeof titles

export interface EditEntry {
  readonly action: EditAction
  readonly keys: readonly string[]
  /** It changes the text. */
  readonly writes?: true
}

/** By the groups of the menu. */
export const EDITS: Readonly<Record<'find' | 'names' | 'lines', readonly EditEntry[]>> = {
  find: [
    { action: 'find', keys: ['Ctrl+F'] },
    { action: 'replace', keys: ['Ctrl+H'], writes: true },
    { action: 'goToLine', keys: ['Ctrl+G'] },
  ],
  names: [
    { action: 'definition', keys: ['F12'] },
    { action: 'references', keys: ['Shift+F12'] },
    { action: 'rename', keys: ['F2'], writes: true },
    { action: 'signature', keys: ['Ctrl+Shift+Space'] },
    { action: 'fix', keys: ['Ctrl+.'], writes: true },
  ],
  lines: [
    { action: 'comment', keys: ['Ctrl+/'], writes: true },
    { action: 'format', keys: ['Alt+Shift+F'], writes: true },
  ],
}

export const EDIT_ENTRIES: readonly EditEntry[] = Object.values(EDITS).flat()
