/** How the editor does what the table of the Edit menu names, and the keys for it. */
import { toggleLineComment } from '@codemirror/commands'
import {
  closeReferencePanel,
  findReferences,
  jumpToDefinition,
  showSignatureHelp,
} from '@codemirror/lsp-client'
import { gotoLine, openSearchPanel } from '@codemirror/search'
import type { Command, KeyBinding } from '@codemirror/view'
import { EDIT_ENTRIES, type EditAction, type EditEntry } from '../studio/edit_table'
import { closeActions, showActions } from './actions_panel'
import { closeRefusals } from './refusals'
import { formatText, renameWord } from './server_edits'

/** A name that was refused before is no answer to the next one. */
const rename: Command = view => {
  closeRefusals(view)
  return renameWord(view)
}

/** The search panel with the keyboard in the field for the new text. */
const replace: Command = view => {
  openSearchPanel(view)
  const field = view.dom.querySelector<HTMLInputElement>('.cm-search [name=replace]')
  field?.select()
  return field !== null
}

const COMMANDS: Readonly<Record<EditAction, Command>> = {
  find: openSearchPanel,
  replace,
  goToLine: gotoLine,
  definition: jumpToDefinition,
  references: findReferences,
  rename,
  signature: showSignatureHelp,
  fix: showActions,
  comment: toggleLineComment,
  format: formatText,
}

/** The command of an action; one that writes leaves alone a text that is only looked at. */
export function commandOf({ action, writes }: EditEntry): Command {
  const command = COMMANDS[action]
  return writes ? view => !view.state.readOnly && command(view) : command
}

/** A key as the editor calls it: `Mod-Shift-Space`. */
function bindingOf(key: string): string {
  const parts = key.replace('Ctrl', 'Mod').split('+')
  const last = parts.pop() ?? ''
  return [...parts, last.length === 1 ? last.toLowerCase() : last].join('-')
}

export const EDIT_KEYS: readonly KeyBinding[] = [
  ...EDIT_ENTRIES.flatMap(entry =>
    entry.keys.map(key => ({
      key: bindingOf(key),
      run: commandOf(entry),
      preventDefault: true,
      scope: 'editor search-panel',
    })),
  ),
  { key: 'Escape', run: view => closeActions(view) || closeReferencePanel(view) || closeRefusals(view) },
]
