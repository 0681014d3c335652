/** What the language server can do about the selection, as a list below the text; what it cannot, with the reason. */
import { LSPPlugin } from '@codemirror/lsp-client'
import { EditorState, StateEffect, StateField, type Text } from '@codemirror/state'
import { type Command, type EditorView, type Panel, showPanel } from '@codemirror/view'
import { changesOf, type Edit } from './places'
import { words } from './words'

export interface Action {
  readonly title: string
  readonly disabled?: { readonly reason: string }
  readonly edit?: { readonly changes?: Readonly<Record<string, readonly Edit[]>> }
}

interface Offer {
  readonly actions: readonly Action[]
  readonly uri: string
  /** The text that was asked about. */
  readonly doc: Text
}

const putOffer = StateEffect.define<Offer | null>()

const offered = StateField.define<Offer | null>({
  create: () => null,
  update(before, transaction) {
    const put = transaction.effects.find(one => one.is(putOffer))
    if (put) return put.value
    return transaction.docChanged ? null : before
  },
  provide: field => showPanel.from(field, offer => (offer ? view => panel(view, offer) : null)),
})

/** Ask what can be done about the selection and show it. */
export const showActions: Command = view => {
  const plugin = LSPPlugin.get(view)
  if (!plugin?.client.connected || view.state.readOnly) return false
  plugin.client.sync()
  const { doc, selection } = view.state
  const { from, to } = selection.main
  const range = { start: plugin.toPosition(from), end: plugin.toPosition(to) }
  const params = { textDocument: { uri: plugin.uri }, range, context: { diagnostics: [] } }
  plugin.client.request<typeof params, readonly Action[] | null>('textDocument/codeAction', params).then(
    found => {
      if (view.state.doc !== doc || LSPPlugin.get(view) !== plugin) return
      view.dispatch({ effects: putOffer.of({ actions: found ?? [], uri: plugin.uri, doc }) })
    },
    () => undefined,
  )
  return true
}

/** Close the list; whether there was one. */
export const closeActions: Command = view => {
  if (!view.state.field(offered, false)) return false
  view.dispatch({ effects: putOffer.of(null) })
  view.focus()
  return true
}

/** The changes that an action makes in a text, null for none. */
export function changesBy(action: Action, uri: string, doc: Text) {
  const edits = action.edit?.changes?.[uri]
  return edits ? changesOf(doc, edits) : null
}

function panel(view: EditorView, offer: Offer): Panel {
  const dom = document.createElement('div')
  dom.className = 'cm-actions'
  dom.setAttribute('role', 'group')
  dom.setAttribute('aria-label', words.actions)
  const entries = offer.actions.map(action => entry(view, offer, action))
  const close = button(words.phrases.close, () => closeActions(view))
  close.name = 'close'
  if (entries.length === 0) {
    const none = document.createElement('span')
    none.textContent = words.noActions
    dom.append(none)
  }
  dom.append(...entries, close)
  dom.addEventListener('keydown', event => {
    if (event.key === 'Escape' && closeActions(view)) event.preventDefault()
  })
  const first = entries.flatMap(one => [...one.querySelectorAll('button')])[0] ?? close
  return { dom, mount: () => first.focus() }
}

function entry(view: EditorView, offer: Offer, action: Action): HTMLElement {
  const line = document.createElement('div')
  if (action.disabled) {
    line.textContent = words.cannot(action.title, action.disabled.reason)
    line.className = 'cm-actions-refused'
    return line
  }
  line.append(button(action.title, () => carryOut(view, offer, action)))
  return line
}

function carryOut(view: EditorView, offer: Offer, action: Action): void {
  const changes = changesBy(action, offer.uri, offer.doc)
  const isSame = view.state.doc === offer.doc && !view.state.facet(EditorState.readOnly)
  if (changes && isSame) {
    view.dispatch({ changes: [...changes], effects: putOffer.of(null), userEvent: 'input.action' })
  }
  view.focus()
}

function button(text: string, act: () => void): HTMLButtonElement {
  const made = document.createElement('button')
  made.type = 'button'
  made.className = 'cm-button'
  made.textContent = text
  made.addEventListener('click', act)
  return made
}

/** The list of actions in an editor. */
export const actionsPanel = offered
