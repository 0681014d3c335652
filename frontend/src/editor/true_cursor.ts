/**
 * Where the browser types is where the cursor stands.
 *
 * Marks that come between two keys move the text before the cursor into other elements. Chromium then types in
 * front of that text, while `getSelection` has the cursor behind it, beside elements instead of in a text. The
 * editor believes that and leaves it; so the cursor is put into the text anew.
 */
import type { Extension } from '@codemirror/state'
import { EditorView } from '@codemirror/view'

export function trueCursor(): Extension {
  return EditorView.updateListener.of(({ view }) => {
    const { main } = view.state.selection
    if (!view.hasFocus || view.composing || !main.empty) return
    const selection = view.contentDOM.ownerDocument.getSelection()
    if (selection?.focusNode?.nodeType !== Node.ELEMENT_NODE) return
    const { node, offset } = view.domAtPos(main.head)
    if (node.nodeType === Node.TEXT_NODE) selection.collapse(node, offset)
  })
}
