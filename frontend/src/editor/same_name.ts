/** Marks of the places that mean the same as the name at the cursor, as the language server knows them. */
import { LSPPlugin } from '@codemirror/lsp-client'
import { StateEffect, StateField, type Text } from '@codemirror/state'
import { Decoration, type DecorationSet, EditorView, ViewPlugin, type ViewUpdate } from '@codemirror/view'
import { offsetOf, type Place } from './places'

export interface Highlight {
  readonly range: { readonly start: Place; readonly end: Place }
  readonly kind?: number
}

const WRITTEN = 3

/** Pause after the cursor has moved [ms]. */
const PAUSE = 150

const putHighlights = StateEffect.define<readonly Highlight[]>()

/** The marks of an answer in a text, in order; places beyond it are left out. */
export function decorations(doc: Text, found: readonly Highlight[]): DecorationSet {
  const marks = found.flatMap(({ range, kind }) => {
    const from = offsetOf(doc, range.start)
    const to = offsetOf(doc, range.end)
    if (from === null || to === null || from >= to) return []
    const mark = Decoration.mark({ class: kind === WRITTEN ? 'cm-name cm-name-written' : 'cm-name' })
    return [mark.range(from, to)]
  })
  return Decoration.set(marks, true)
}

const shown = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(before, transaction) {
    const put = transaction.effects.find(one => one.is(putHighlights))
    if (put) return decorations(transaction.state.doc, put.value)
    return transaction.docChanged ? Decoration.none : before
  },
  provide: field => EditorView.decorations.from(field),
})

const asks = ViewPlugin.fromClass(
  class {
    #timer: ReturnType<typeof setTimeout> | undefined

    constructor(readonly view: EditorView) {}

    update(update: ViewUpdate): void {
      if (!update.docChanged && !update.selectionSet) return
      clearTimeout(this.#timer)
      this.#timer = setTimeout(() => this.#ask(), PAUSE)
    }

    destroy(): void {
      clearTimeout(this.#timer)
    }

    #ask(): void {
      const { view } = this
      const plugin = LSPPlugin.get(view)
      if (!plugin?.client.connected) return
      plugin.client.sync()
      const { doc, selection } = view.state
      const params = {
        textDocument: { uri: plugin.uri },
        position: plugin.toPosition(selection.main.head),
      }
      const put = (found: readonly Highlight[] | null) => {
        // Not by the time: what was asked about an older text or cursor is no answer any more.
        if (view.state.doc !== doc || !view.state.selection.eq(selection)) return
        if (LSPPlugin.get(view) === plugin) view.dispatch({ effects: putHighlights.of(found ?? []) })
      }
      plugin.client
        .request<typeof params, readonly Highlight[] | null>('textDocument/documentHighlight', params)
        .then(put, () => undefined)
    }
  },
)

/** Mark the places of the name at the cursor. */
export const sameName = [shown, asks]
