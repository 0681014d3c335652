/** What is read under the pointer may be answered late: where the pointer has gone by then, it is closed again. */
import type { Extension } from '@codemirror/state'
import { closeHoverTooltips, EditorView, hasHoverTooltips } from '@codemirror/view'

export function closesLateWords(): Extension {
  return EditorView.updateListener.of(({ view, state, startState }) => {
    if (!hasHoverTooltips(state) || hasHoverTooltips(startState) || view.dom.matches(':hover')) return
    // A view takes nothing new while it is told of a change.
    queueMicrotask(() => view.dispatch({ effects: closeHoverTooltips }))
  })
}
