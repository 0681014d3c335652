/** Panels above and below the text take room from it: the line of the cursor stays in sight where it was. */
import type { Extension } from '@codemirror/state'
import { type EditorView, ViewPlugin, type ViewUpdate } from '@codemirror/view'

/** Room that stays between the line and a panel [px]. */
const MARGIN = 6

/** Part of the text that is seen [px]. */
export interface Seen {
  readonly top: number
  readonly height: number
}

/** Where the text is to be scrolled to once less of it is seen, so that a block which was seen still is. */
export function scrolledTo(block: { top: number; bottom: number }, before: Seen, height: number): number {
  const wasSeen = block.top >= before.top && block.bottom <= before.top + before.height
  if (!wasSeen || height >= before.height) return before.top
  return Math.max(before.top, Math.min(block.bottom + MARGIN - height, block.top))
}

function seenOf({ scrollDOM }: EditorView): Seen {
  return { top: scrollDOM.scrollTop, height: scrollDOM.clientHeight }
}

export function panelRoom(): Extension {
  return ViewPlugin.fromClass(
    class {
      #height: number

      constructor(view: EditorView) {
        this.#height = view.scrollDOM.clientHeight
      }

      update({ geometryChanged, view }: ViewUpdate): void {
        if (geometryChanged)
          view.requestMeasure({ key: this, read: seenOf, write: seen => this.#shrunk(seen, view) })
      }

      #shrunk(seen: Seen, view: EditorView): void {
        const block = view.lineBlockAt(view.state.selection.main.head)
        const top = scrolledTo(block, { ...seen, height: this.#height }, seen.height)
        this.#height = seen.height
        if (top !== seen.top) view.scrollDOM.scrollTop = top
      }
    },
  )
}
