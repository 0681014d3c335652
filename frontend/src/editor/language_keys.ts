/** The keys that ask the language server; the key sheet lists them. */
import {
  closeReferencePanel,
  findReferences,
  jumpToDefinition,
  renameSymbol,
  showSignatureHelp,
} from '@codemirror/lsp-client'
import type { Command, KeyBinding } from '@codemirror/view'
import { closeActions, showActions } from './actions_panel'

/** A text that is only looked at keeps its names. */
const rename: Command = view => !view.state.readOnly && renameSymbol(view)

export const LANGUAGE_KEYS: readonly KeyBinding[] = [
  { key: 'F12', run: jumpToDefinition, preventDefault: true },
  { key: 'Shift-F12', run: findReferences, preventDefault: true },
  { key: 'F2', run: rename, preventDefault: true },
  { key: 'Mod-Shift-Space', run: showSignatureHelp, preventDefault: true },
  { key: 'Mod-.', run: showActions, preventDefault: true },
  { key: 'Escape', run: view => closeActions(view) || closeReferencePanel(view) },
]
