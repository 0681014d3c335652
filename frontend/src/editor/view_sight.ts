/** The lines of an editor's view as they are seen, and what counts as the user being busy with them. */
import type { Transaction } from '@codemirror/state'
import { EditorView } from '@codemirror/view'
import { LineInSight } from './line_in_sight'

export function lineInSight(view: EditorView): LineInSight {
  const { scrollDOM } = view
  const sight = new LineInSight({
    block: line => view.lineBlockAt(view.state.doc.line(line).from),
    seen: () => ({ top: scrollDOM.scrollTop, bottom: scrollDOM.scrollTop + scrollDOM.clientHeight }),
    scroll: (line, yMargin) => {
      const at = view.state.doc.line(line).from
      view.dispatch({ effects: EditorView.scrollIntoView(at, { y: 'nearest', yMargin }) })
    },
  })
  for (const kind of ['wheel', 'pointerdown', 'keydown', 'touchmove']) {
    view.dom.addEventListener(kind, () => sight.touch(), { passive: true })
  }
  return sight
}

/** Carry out a change while the place `at` of the text stays where it is seen. */
export function inPlace(view: EditorView, at: number, change: Transaction): void {
  const before = view.coordsAtPos(at)?.top
  view.dispatch(change)
  const after = view.coordsAtPos(change.changes.mapPos(at, 1))?.top
  if (before !== undefined && after !== undefined) view.scrollDOM.scrollTop += after - before
}
