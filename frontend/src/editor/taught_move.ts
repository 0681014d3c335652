/** A taught pose: a point with a name above, and at the cursor a move to it, or its name where that is missing. */
import { invertedEffects } from '@codemirror/commands'
import { getIndentation, IndentContext, indentString } from '@codemirror/language'
import {
  type ChangeSpec,
  type EditorState,
  type Line,
  StateEffect,
  StateField,
  type TransactionSpec,
} from '@codemirror/state'
import { MARKS, statementAt } from './block_lines'

/** Behind this the target itself is missing: a word that takes one, an operator, an opening parenthesis. */
const OPEN = /(?:^|[\s(])(?:mov[jlc]?|lin|circ|spline|via|to|from|in|and|or|not)\s*$|[=(,+*/-]\s*$/i
/** What stands before everything else; no location belongs there. */
const OPENING = /^\s*(?:program|units|classic|strict)\b/i
/** Statements that hold before the program runs; what they name is known below. */
const DECLARATION = /^\s*(?:program|units|classic|strict|frame|loc|tool|signal|const|var|pattern)\b/i
/** A location begins here. */
const GIVEN = /^\s*[(\d]/
/** A move whose target is missing before what says how it goes there. */
const AIMLESS =
  /^(\s*(?:\d+\.\s+)?(?:mov|lin))(\s+)(?:above|offset|rel|speed|acc|blend|fine|until|external|free)\b/i
const POINT = /^\s*loc\b/i
const NOTE = /^\s*(?:$|#|\/\/)/
const NAMED = /^\s*loc\s+(\w+)\s*:?=\s*(.*?)\s*$/i

/** The change with this number stands again, or was undone. */
const setStanding = StateEffect.define<{ readonly number: number; readonly stands: boolean }>()

/** Numbers of the changes that taught something and were not undone, by whatever key. */
const standing = StateField.define<ReadonlySet<number>>({
  create: () => new Set(),
  update(before, transaction) {
    const found = transaction.effects.filter(one => one.is(setStanding))
    if (found.length === 0) return before
    const now = new Set(before)
    for (const { value } of found) {
      if (value.stands) now.add(value.number)
      else now.delete(value.number)
    }
    return now
  },
})

/** What an editor needs to know which taught changes stand; its history carries it back and forth. */
export const standingTaught = [
  standing,
  invertedEffects.of(transaction =>
    transaction.effects
      .filter(one => one.is(setStanding))
      .map(({ value }) => setStanding.of({ ...value, stands: !value.stands })),
  ),
]

/** The effect that marks a change as one that taught something, under a number of its own. */
export function asTaught(number: number): StateEffect<unknown> {
  return setStanding.of({ number, stands: true })
}

export function stands(state: EditorState, number: number): boolean {
  return state.field(standing, false)?.has(number) ?? false
}

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
  const isThere = GIVEN.test(behind)
  const isDeclared = DECLARATION.test(line.text) && !OPENING.test(line.text)
  if (isDeclared && ((isMissing && !isThere) || !main.empty)) return piece(location, null, main)
  const head = headOf(state.doc.toString().split('\n'))
  const point = pointFor(state, location, taken, head)
  if (line.number <= head.end) return withLine(state, point, 'below', state.doc.line(head.end))
  const aimless = main.empty ? AIMLESS.exec(line.text) : null
  if (aimless) {
    const [, move = '', gap = ''] = aimless
    const from = line.from + move.length
    return piece(` ${point.name}`, point.declared, { from, to: from + gap.length - 1 })
  }
  if (!main.empty || isMissing) return piece(point.name, point.declared, main)
  const isTaught = state.field(lastTaught, false) === main.head
  const isAbove = before.trim() === '' && behind.trim() !== '' && !isTaught
  if (behind.trim() !== '' && !isAbove && !isTaught) return piece(point.name, point.declared, main)
  return withLine(state, point, line.text.trim() === '' ? 'here' : isAbove ? 'above' : 'below', line)
}

/** Whether a line has come to its comment. */
function isNote(before: string): boolean {
  return [...before.matchAll(MARKS)].some(([mark]) => mark.startsWith('#') || mark.startsWith('//'))
}

interface Stretch {
  readonly from: number
  readonly to: number
}

/** The change that writes a text in place of a stretch. */
function piece(text: string, declared: Point['declared'], { from, to }: Stretch): TransactionSpec {
  const anchor = from + (declared?.insert.length ?? 0) + text.length
  return { changes: changed(declared, { from, to, insert: text }), selection: { anchor } }
}

/** The change that writes a move as a line of its own beside a line, with the cursor at its first letter. */
function withLine(
  state: EditorState,
  point: Point,
  side: 'here' | 'above' | 'below',
  line: Line,
): TransactionSpec {
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
function pointFor(
  { doc, selection }: EditorState,
  location: string,
  taken: ReadonlySet<string>,
  head: Head,
): Point {
  const cursor = doc.lineAt(selection.main.from)
  const lines = doc.toString().split('\n')
  const same = lines.slice(0, Math.max(cursor.number - 1, head.end)).map(line => NAMED.exec(line))
  const known = same.find(found => found?.[2] === location)?.[1]
  if (known) return { name: known, declared: null }
  let number = 1
  while (taken.has(`p${number}`)) number += 1
  const name = `p${number}`
  const insert = `loc ${name} = ${location}`
  if (head.end > 0) return { name, declared: { from: doc.line(head.place).to, insert: `\n${insert}` } }
  const first = lines.slice(0, cursor.number - 1).findIndex(line => !NOTE.test(line))
  const from = first < 0 ? cursor.from : doc.line(first + 1).from
  return { name, declared: { from, insert: `${insert}\n` } }
}

/** Lines (from 1) of the declarations at the head of a text, 0 where it has none. */
interface Head {
  /** The last one: no move stands before it. */
  readonly end: number
  /** Behind this one a point is declared: the last `loc`, else the last declaration. */
  readonly place: number
}

function headOf(lines: readonly string[]): Head {
  let [point, end] = [0, 0]
  for (let at = 0; at < lines.length; ) {
    const statement = statementAt(lines, at)
    const text = lines[at] ?? ''
    if (!NOTE.test(text) && !DECLARATION.test(text)) break
    at += statement.length
    if (POINT.test(text)) point = at
    if (!NOTE.test(text)) end = at
  }
  return { end, place: point || end }
}
