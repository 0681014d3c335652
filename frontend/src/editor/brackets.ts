/** Brackets and quotes that close themselves: in code, not in comments, prose and texts that have their end. */
import { closeBrackets } from '@codemirror/autocomplete'
import { EditorState, type Extension, Facet } from '@codemirror/state'

/** How texts and comments of a language begin. */
export interface Signs {
  readonly brackets: readonly string[]
  /** What begins a comment that ends with its line. */
  readonly comment: string
  /** Quotes around texts; a backslash takes the quote behind it for a letter. */
  readonly quotes: string
  /** Lines that are prose. */
  readonly prose?: RegExp
}

/** The signs of the language of an editor. */
const signsOf = Facet.define<Signs>()
/** Quotes of texts that go on in the next line. */
const LONG = /"""|'''/

type Place = 'code' | 'text' | 'note'

/** Where the end of a piece of line stands. */
function placeAt(before: string, { comment, quotes, prose }: Signs): Place {
  if (prose?.test(before)) return 'note'
  const texts = [...quotes].map(quote => `${quote}(?:[^${quote}\\\\]|\\\\.)*${quote}`)
  const marks = new RegExp([...texts, comment, `[${quotes}]`].join('|'), 'g')
  for (const [mark] of before.matchAll(marks)) {
    if (!quotes.includes(mark[0] ?? '')) return 'note'
    if (mark.length === 1) return 'text'
  }
  return 'code'
}

/** The signs that may be closed at a place: in a text its end alone, where that stands already. */
function closedAt(state: EditorState, place: number, signs: Signs): readonly string[] {
  const line = state.doc.lineAt(place)
  const before = line.text.slice(0, place - line.from)
  const at = placeAt(before, signs)
  if (at === 'code') return signs.brackets
  const isEscaped = (/\\*$/.exec(before)?.[0].length ?? 0) % 2 === 1
  const next = line.text[place - line.from] ?? ''
  return at === 'text' && !isEscaped && next && signs.quotes.includes(next) ? [next] : []
}

/** The quote at a place that ends the text before it on the same line; empty if there is none. */
export function endOfText(state: EditorState, place: number): string {
  const line = state.doc.lineAt(place)
  const before = line.text.slice(0, place - line.from)
  const next = line.text[place - line.from] ?? ''
  const isEnd = state
    .facet(signsOf)
    .some(signs => next && signs.quotes.includes(next) && placeAt(before, signs) === 'text')
  return isEnd && !LONG.test(line.text) ? next : ''
}

export function brackets(signs: Signs): Extension {
  return [
    signsOf.of(signs),
    closeBrackets(),
    EditorState.languageData.of((state, place) => [
      { closeBrackets: { brackets: closedAt(state, place, signs) } },
    ]),
  ]
}
