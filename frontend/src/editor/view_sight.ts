/** The lines of an editor's view as they are seen, and what counts as the user being busy with them. */
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
