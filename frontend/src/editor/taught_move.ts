/** A taught pose: a point with a name above, and at the cursor a move to it, or its name where that is missing. */
import { getIndentation, IndentContext, indentString } from '@codemirror/language'
import {
  type ChangeSpec,
  type EditorState,
  StateEffect,
  StateField,
  type TransactionSpec,
} from '@codemirror/state'
import { MARKS, statementAt } from './block_lines'

/** Behind this the target itself is missing: a word that takes one, an operator, an opening parenthesis. */
const OPEN = /(?:^|[\s(])(?:mov[jlc]?|lin|circ|spline|via|to|from|in|and|or|not)\s*$|[=(,+*/-]\s*$/i
/** Statements that hold before the program runs; what they name is known below. */
const DECLARATION = /^\s*(?:program|units|classic|strict|frame|loc|tool|signal|const|var|pattern)\b/i
const POINT = /^\s*loc\b/i
const NOTE = /^\s*(?:$|#|\/\/)/
const NAMED = /^\s*loc\s+(\w+)\s*:?=\s*(.*?)\s*$/i

const setTaught = StateEffect.define<number>()

/** Where the line that was taught last begins, as long as the cursor stays there; the next one goes below it. */
export const lastTaught = StateField.define<number | null>({
  create: () => null,
  update(before, transaction) {
    const put = transaction.effects.find(one => one.is(setTaught))
    if (put) return put.value
    if (before === null || transaction.docChanged) return null
    return transaction.newSelection.main.head === before ? before : null
  },
})

interface Point {
  readonly name: string
  /** What declares it, and where; null where it is declared already. */
  readonly declared: { readonly from: number; readonly insert: string } | null
}

/**
 * The change that teaches a location.
 *
 * @param location as a text of the task language
 * @param taken names that mean something already, in small letters
 */
export function taughtMove(
  state: EditorState,
  location: string,
  taken: ReadonlySet<string>,
): TransactionSpec {
  const { main } = state.selection
  const line = state.doc.lineAt(main.from)
  const before = line.text.slice(0, main.from - line.from)
  const behind = line.text.slice(main.from - line.from)
  const isMissing = OPEN.test(before) && !isNote(before)
  if (DECLARATION.test(line.text) && (isMissing || !main.empty)) return piece(state, location, null)
  const point = pointFor(state, location, taken)
  if (!main.empty || isMissing) return piece(state, point.name, point.declared)
  const isTaught = state.field(lastTaught, false) === main.head
  const isAbove = before.trim() === '' && behind.trim() !== '' && !isTaught
  if (behind.trim() !== '' && !isAbove && !isTaught) return piece(state, point.name, point.declared)
  return withLine(state, point, line.text.trim() === '' ? 'here' : isAbove ? 'above' : 'below')
}

/** Whether a line has come to its comment. */
function isNote(before: string): boolean {
  return [...before.matchAll(MARKS)].some(([mark]) => mark.startsWith('#') || mark.startsWith('//'))
}

/** The change that writes a text in place of what is selected. */
function piece(state: EditorState, text: string, declared: Point['declared']): TransactionSpec {
  const { from, to } = state.selection.main
  const anchor = from + (declared?.insert.length ?? 0) + text.length
  return { changes: changed(declared, { from, to, insert: text }), selection: { anchor } }
}

/** The change that writes a move as a line of its own, with the cursor at its first letter. */
function withLine(state: EditorState, point: Point, side: 'here' | 'above' | 'below'): TransactionSpec {
  const line = state.doc.lineAt(state.selection.main.head)
  const move = `mov ${point.name}`
  const blank = /^\s*/.exec(line.text)?.[0] ?? ''
  const place = side === 'below' ? line.to : line.from
  const broken = side === 'below' ? { simulateBreak: place } : {}
  const depth = getIndentation(new IndentContext(state, broken), place) ?? 0
  const indent = side === 'above' || (side === 'here' && blank) ? blank : indentString(state, depth)
  const written = {
    here: { from: line.from, to: line.to, insert: `${indent}${move}` },
    above: { from: line.from, insert: `${indent}${move}\n` },
    below: { from: line.to, insert: `\n${indent}${move}` },
  }[side]
  const begin = (side === 'below' ? 1 : 0) + indent.length
  const anchor = written.from + (point.declared?.insert.length ?? 0) + begin
  return {
    changes: changed(point.declared, written),
    selection: { anchor },
    effects: setTaught.of(anchor),
  }
}

function changed(declared: Point['declared'], written: ChangeSpec): ChangeSpec {
  return declared ? [declared, written] : written
}

/** The point at a location: one that is declared so above, else a new one. */
function pointFor(state: EditorState, location: string, taken: ReadonlySet<string>): Point {
  const { doc, selection } = state
  const cursor = doc.lineAt(selection.main.from)
  const lines = doc.toString().split('\n')
  const same = lines.slice(0, cursor.number - 1).map(line => NAMED.exec(line))
  const known = same.find(found => found?.[2] === location)?.[1]
  if (known) return { name: known, declared: null }
  let number = 1
  while (taken.has(`p${number}`)) number += 1
  const name = `p${number}`
  const insert = `loc ${name} = ${location}`
  const last = lastDeclaration(lines.slice(0, cursor.number))
  if (last !== null && last < cursor.number) {
    return { name, declared: { from: doc.line(last).to, insert: `\n${insert}` } }
  }
  const first = lines.slice(0, cursor.number - 1).findIndex(line => !NOTE.test(line))
  const from = first < 0 ? cursor.from : doc.line(first + 1).from
  return { name, declared: { from, insert: `${insert}\n` } }
}

/** The line (from 1) behind which a point is declared: the last `loc` of the head, else its last declaration. */
function lastDeclaration(lines: readonly string[]): number | null {
  let [point, other]: (number | null)[] = [null, null]
  for (let at = 0; at < lines.length; ) {
    const statement = statementAt(lines, at)
    const text = lines[at] ?? ''
    if (!NOTE.test(text) && !DECLARATION.test(text)) break
    at += statement.length
    if (POINT.test(text)) point = at
    else if (DECLARATION.test(text)) other = at
  }
  return point ?? other ?? null
}
