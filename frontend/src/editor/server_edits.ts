/** What the language server writes when asked, its form and new names: all of it, in the texts that it was asked about. */

import { getIndentUnit } from '@codemirror/language'
import { LSPPlugin } from '@codemirror/lsp-client'
import { ChangeSet, type Text } from '@codemirror/state'
import { type Command, type EditorView, getDialog, showDialog } from '@codemirror/view'
import { LineEnds } from './line_ends'
import { changesOf, type Edit } from './places'
import { replacements } from './replacement'
import { words } from './words'
import { type ProjectWorkspace, textOf } from './workspace'

type Edits = Readonly<Record<string, readonly Edit[]>>

const PANEL = 'cm-lsp-rename-panel'

/** The smallest changes that make edits in a text; null where one of them stands on no line of it. */
export function smallest(doc: Text, edits: readonly Edit[]): ChangeSet | null {
  const changes = changesOf(doc, edits)
  if (!changes) return null
  const after = ChangeSet.of([...changes], doc.length).apply(doc)
  return ChangeSet.of([...replacements(doc.toString(), after.toString())], doc.length)
}

/**
 * The changes of all texts that edits mean; null where there is none to make or they cannot all be made.
 *
 * @param asked texts that the server was asked about, by their addresses
 * @param now texts as they are; one that has changed since takes no edit, and then no other does
 */
export function changesIn(
  edits: Edits,
  asked: ReadonlyMap<string, Text>,
  now: ReadonlyMap<string, Text>,
): ReadonlyMap<string, ChangeSet> | null {
  const changes = new Map<string, ChangeSet>()
  for (const [uri, some] of Object.entries(edits)) {
    const [before, doc] = [asked.get(uri), now.get(uri)]
    const change = before && doc?.eq(before) ? smallest(doc, some) : null
    if (!change) return null
    changes.set(uri, change)
  }
  return changes
}

/** A text with its own line ends after a change of its lines. */
export function changedText(text: string, change: ChangeSet): string {
  const [doc, ends] = [textOf(text), new LineEnds(text)]
  const after = change.apply(doc)
  ends.change(doc, after, change)
  return ends.text(after)
}

/** Bring the text into its one form. */
export const formatText: Command = view => {
  const plugin = LSPPlugin.get(view)
  if (!plugin?.client.connected) return false
  const options = { tabSize: getIndentUnit(view.state), insertSpaces: true }
  void ask<readonly Edit[]>(plugin, 'textDocument/formatting', { options }, words.notFormatted, edits => ({
    [plugin.uri]: edits,
  }))
  return true
}

/** Ask for a new name of the word at the cursor, and give it that name in all texts. */
export const renameWord: Command = view => {
  const at = view.state.wordAt(view.state.selection.main.head)
  if (!at || !LSPPlugin.get(view)?.client.connected) return false
  const word = view.state.sliceDoc(at.from, at.to)
  const open = getDialog(view, PANEL)?.dom.querySelector<HTMLInputElement>('[name=name]')
  if (open) {
    open.value = word
    open.select()
    return true
  }
  const { close, result } = showDialog(view, {
    label: view.state.phrase('New name'),
    input: { name: 'name', value: word },
    focus: true,
    submitLabel: view.state.phrase('rename'),
    class: PANEL,
  })
  result.then(form => {
    view.dispatch({ effects: close })
    view.focus()
    const name = form && new FormData(form).get('name')
    if (typeof name === 'string') rename(view, name)
  })
  return true
}

function rename(view: EditorView, newName: string): void {
  const plugin = LSPPlugin.get(view)
  const at = view.state.wordAt(view.state.selection.main.head)
  if (!plugin?.client.connected || !at) return
  const params = { position: plugin.toPosition(at.from), newName }
  void ask<{ changes?: Edits }>(
    plugin,
    'textDocument/rename',
    params,
    words.notRenamed,
    answer => answer.changes ?? {},
  )
}

/** Ask for edits and make them all, or say why none is made. */
async function ask<Answer>(
  plugin: LSPPlugin,
  method: string,
  params: object,
  refused: string,
  editsOf: (answer: Answer) => Edits,
): Promise<void> {
  const workspace = plugin.client.workspace as ProjectWorkspace
  plugin.client.sync()
  const asked = workspace.texts
  try {
    const request = { ...params, textDocument: { uri: plugin.uri } }
    const answer = await plugin.client.request<typeof request, Answer | null>(method, request)
    if (!answer) return
    const changes = changesIn(editsOf(answer), asked, workspace.texts)
    if (!changes) throw new Error(words.textMoved)
    for (const [uri, change] of changes) workspace.change(uri, change)
  } catch (error) {
    if (LSPPlugin.get(plugin.view) === plugin) plugin.reportError(refused, error)
  }
}
