/** What the language server refuses, such as a new name, as a bar above the text: gone with Escape or the next word. */
import { type Command, EditorView } from '@codemirror/view'

const CLOSE = '.cm-lsp-message .cm-dialog-close'

/** Close the bars; whether there were any. */
export const closeRefusals: Command = view => {
  const buttons = view.dom.querySelectorAll<HTMLButtonElement>(CLOSE)
  for (const button of buttons) button.click()
  return buttons.length > 0
}

/** A text that has changed is not the one that was refused. */
export const refusalsOfThisText = EditorView.updateListener.of(({ docChanged, view }) => {
  // The view is being updated; what closes a bar updates it once more.
  if (docChanged && view.dom.querySelector(CLOSE)) queueMicrotask(() => closeRefusals(view))
})
