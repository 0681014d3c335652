/** What the language server offers, as a list that never takes a key of somebody who types on. */
import {
  acceptCompletion,
  autocompletion,
  type CompletionContext,
  type CompletionResult,
  type CompletionSource,
  completionStatus,
  selectedCompletionIndex,
  setSelectedCompletion,
} from '@codemirror/autocomplete'
import { EditorState, type Extension, Prec } from '@codemirror/state'
import { type Command, keymap } from '@codemirror/view'

/** What of a list is new beside the text in its place: a word written in full leaves only longer ones. */
function fresh(options: CompletionResult['options'], written: string): CompletionResult['options'] {
  const word = written.toLowerCase()
  const labels = options.map(one => one.label.toLowerCase())
  if (!word || !labels.includes(word)) return options
  return options.filter((_, at) => labels[at] !== word && labels[at]?.startsWith(word))
}

/** Whether a text still is what a list was made for. */
function fits({ validFor }: CompletionResult, text: string, from: number, to: number, state: EditorState) {
  if (typeof validFor === 'function') return validFor(text, from, to, state)
  return validFor !== undefined && new RegExp(`^(?:${validFor.source})$`, validFor.flags).test(text)
}

/** A list as far as it is new, and again after each letter that is typed. */
function narrowed(found: CompletionResult, { state, pos }: CompletionContext, to: number): CompletionResult {
  const { validFor: _, ...list } = found
  return {
    ...list,
    options: fresh(found.options, state.sliceDoc(found.from, Math.max(to, pos))),
    update: (_before, from, end, context) => {
      const text = context.state.sliceDoc(from, end)
      return fits(found, text, from, end, context.state)
        ? narrowed({ ...found, from, to: end }, context, end)
        : null
    },
  }
}

/** A source whose lists, unless they are asked for by key, hold only what is new. */
export function newOnly(source: CompletionSource): CompletionSource {
  return async context => {
    const found = await source(context)
    return found && !context.explicit ? narrowed(found, context, found.to ?? context.pos) : found
  }
}

/** Take the chosen entry, without a choice the first one. */
const acceptFirst: Command = view => {
  if (completionStatus(view.state) !== 'active') return false
  const chosen = selectedCompletionIndex(view.state)
  if (chosen === null) view.dispatch({ effects: setSelectedCompletion(0) })
  if (acceptCompletion(view)) return true
  if (chosen === null) view.dispatch({ effects: setSelectedCompletion(-1) }) // the list is too young to be seen
  return false
}

/** Typing on gives up what was chosen in the list. */
const unchosen = EditorState.transactionExtender.of(typed =>
  typed.docChanged && typed.isUserEvent('input.type') ? { effects: setSelectedCompletion(-1) } : null,
)

/** Tab takes from the list; Enter does so behind an arrow key and breaks the line else. */
export function completions(source: CompletionSource): Extension {
  return [
    autocompletion({ override: [newOnly(source)], selectOnOpen: false }),
    Prec.highest(keymap.of([{ key: 'Tab', run: acceptFirst }])),
    unchosen,
  ]
}
