/** Tests: a program at random, and somebody who types it key by key without a leading blank. */
import { insertBracket } from '@codemirror/autocomplete'
import { deleteCharBackward, history } from '@codemirror/commands'
import { indentUnit } from '@codemirror/language'
import { EditorState, type StateCommand } from '@codemirror/state'
import { breakLine } from './line_break'
import { task } from './task_language'

/** Numbers at random, the same for a seed (mulberry32). */
export function dice(seed: number): (below: number) => number {
  let state = seed
  return below => {
    state = (state + 0x6d2b79f5) | 0
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state)
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed
    return Math.floor((((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296) * below)
  }
}

const PLAIN = [
  'wait 1 s',
  'mov home',
  'lin p speed 100 mm/s',
  'mov (500, 0, 600; rpy 0 180 0)',
  'ending = 3',
  'end = 3',
  'endless = end + 1',
  'elsewhere = (1 + 2) * 3',
  'until_then = 2',
  'print "done", n',
  'print "say \\"(\\" twice"',
  'if a then mov home',
  'if a then b = 2 else b = 3',
  'open  # and say "hi',
  '# one ( too many, 5" wide',
  'set lamp on // [ here',
  'Carry pick_up, set_down',
  '',
]
const HEADS: readonly (readonly [head: string, closers: readonly string[], dividers: readonly string[]])[] = [
  ['repeat 3', ['endr', 'end', 'until lamp', 'until lamp is on'], []],
  ['while a < b do', ['endw', 'end'], []],
  ['while a < b', ['endw', 'END'], []],
  ['for each b in slots', ['endf', 'end'], []],
  ['for i = 1 to 3', ['endf  # of i', 'end'], []],
  ['if lamp then', ['endif', 'end'], ['elseif n > 3', 'else']],
  ['if lamp then  # only so', ['endif'], ['else']],
  ['if n > 3', ['endif', 'Endif'], ['elseif n > 2 then', 'ELSE  # at last']],
  ['with frame pallet, speed 100 mm/s', ['endwith', 'end'], []],
]

/** The lines of a program as it should stand, two blanks to a block. */
export function programLines(seed: number): readonly string[] {
  const roll = dice(seed)
  const pick = <T>(from: readonly T[]): T => from[roll(from.length)] as T
  const lines: string[] = ['program made', 'units mm, deg, s']
  const put = (depth: number, text: string) => lines.push(text && '  '.repeat(depth) + text)
  const block = (depth: number) => {
    for (let count = 1 + roll(3); count > 0; count -= 1) {
      const kind = depth > 3 ? 8 : roll(12)
      if (kind === 0) {
        put(depth, 'mov (100, 200,')
        put(depth, '     300)')
      } else if (kind === 1) {
        put(depth, 'total = one + \\')
        put(depth + 1, 'two')
      } else if (kind > 4) {
        put(depth, pick(PLAIN))
      } else {
        const [head, closers, dividers] = pick(HEADS)
        put(depth, head)
        block(depth + 1)
        for (const divider of dividers) {
          if (roll(2) === 0) continue
          put(depth, divider)
          block(depth + 1)
        }
        put(depth, pick(closers))
      }
    }
  }
  for (let tasks = roll(3); tasks > 0; tasks -= 1) {
    put(0, `task T${tasks}(a: loc)`)
    if (roll(2) === 0) put(1, 'needs a jaw 5" wide (open)')
    block(1)
    put(0, pick(['endp', 'endtask', 'end']))
    put(0, '')
  }
  block(0)
  put(0, 'stop')
  return lines
}

/** The keys for a text: its lines without their leading blanks; now and then a letter too much, taken back. */
export function keysOf(lines: readonly string[], roll: (below: number) => number): readonly string[] {
  const keys: string[] = []
  for (const [at, line] of lines.entries()) {
    if (at > 0) keys.push('Enter')
    for (const sign of line.trimStart()) {
      if (roll(40) === 0) keys.push('e', 'Backspace')
      keys.push(sign)
    }
  }
  return keys
}

export function emptyEditor(doc = ''): EditorState {
  return EditorState.create({
    doc,
    selection: { anchor: doc.length },
    extensions: [task(), history(), indentUnit.of('  ')],
  })
}

function after(state: EditorState, command: StateCommand): EditorState {
  let next = state
  command({ state, dispatch: transaction => (next = transaction.state) })
  return next
}

/** The editor after a key, as its view treats it where no list is open. */
export function pressed(state: EditorState, key: string): EditorState {
  if (key === 'Enter') return after(state, breakLine)
  if (key === 'Backspace') return after(state, one => deleteCharBackward(one as never))
  const bracket = insertBracket(state, key)
  if (bracket) return bracket.state
  return state.update(state.replaceSelection(key), { userEvent: 'input.type' }).state
}

export function typed(keys: readonly string[], from = emptyEditor()): EditorState {
  return keys.reduce(pressed, from)
}
