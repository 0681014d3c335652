import { redo, undo } from '@codemirror/commands'
import type { EditorState, StateCommand } from '@codemirror/state'
import { describe, expect, it, test } from 'vitest'
import { dice, emptyEditor, keysOf, pressed, programLines, typed } from './typist'

/** Programs typed in each run of the tests; `TYPED=20000` types more. */
const MANY = Number(process.env.TYPED ?? 15)
/** Ends a hang [ms]. */
const PATIENCE = 3_600_000

function done(state: EditorState, command: StateCommand): EditorState | null {
  let next: EditorState | null = null
  command({ state, dispatch: transaction => (next = transaction.state) })
  return next
}

test(
  'programs typed without a leading blank stand as deep as their blocks, with every key they were typed with',
  () => {
    for (let seed = 0; seed < MANY; seed += 1) {
      const lines = programLines(seed)
      expect(typed(keysOf(lines, dice(seed))).doc.toString(), `seed ${seed}`).toBe(lines.join('\n'))
    }
  },
  PATIENCE,
)

test(
  'every step of undo and redo is a text that was typed',
  () => {
    for (let seed = 0; seed < 6; seed += 1) {
      const seen = new Set<string>([''])
      let state = emptyEditor()
      for (const key of keysOf(programLines(seed), dice(seed))) {
        state = pressed(state, key)
        seen.add(state.doc.toString())
      }
      const whole = state.doc.toString()
      for (let back = done(state, undo); back; back = done(state, undo)) {
        state = back
        expect(seen).toContain(state.doc.toString())
      }
      expect(state.doc.toString()).toBe('')
      for (let again = done(state, redo); again; again = done(state, redo)) state = again
      expect(state.doc.toString()).toBe(whole)
    }
  },
  PATIENCE,
)

/** A text after keys at `|`, with the cursor as `|`. */
function at(marked: string, keys: readonly string[]): string {
  const place = marked.indexOf('|')
  const doc = marked.replace('|', '')
  const begin = emptyEditor(doc).update({ selection: { anchor: place } }).state
  const state = typed(keys, begin)
  const { head } = state.selection.main
  return `${state.sliceDoc(0, head)}|${state.sliceDoc(head)}`
}

describe('depth', () => {
  it.each([
    ['task T|', 'task T\n  |'],
    ['task T\n    open|\nendp', 'task T\n    open\n    |\nendp'],
    ['task T\nopen|\nendp', 'task T\nopen\n|\nendp'],
    ['if a then mov home|', 'if a then mov home\n|'],
    ['if a then mov home else open|', 'if a then mov home else open\n|'],
    ['print "if x then y"|', 'print "if x then y"\n|'],
    ['if t is "then x"|', 'if t is "then x"\n  |'],
    ['repeat 3\n  if a\n    open\n  endif|', 'repeat 3\n  if a\n    open\n  endif\n  |'],
    ['repeat 3\n  |endr', 'repeat 3\n\n  |endr'],
    ['repeat 3\n  open|endr', 'repeat 3\n  open\n|endr'],
    ['  open\n|  close', '  open\n\n  |close'],
    ['repeat 3\n  open\n  |', 'repeat 3\n  open\n\n  |'],
    ['mov (1, 2,|)', 'mov (1, 2,\n    |)'],
    ['mov (|)', 'mov (\n|)'],
    ['x = a + \\|', 'x = a + \\\n  |'],
    ['1. Task "a"|', '1. Task "a"\n  |'],
  ])('Enter in %j', (before, behind) => {
    expect(at(before, ['Enter'])).toBe(behind)
  })

  it.each([
    ['if a\n  open\n  |', 'else', 'if a\n  open\nelse|'],
    ['if a\n  repeat\n    open\n    |', 'endif', 'if a\n  repeat\n    open\nendif|'],
    ['if a\n  |', 'endr', 'if a\n  endr|'],
    ['if a\n  |', 'end', 'if a\nend|'],
    ['if a\n  |', 'ending', 'if a\n  ending|'],
    ['if a\n    |', 'endif', 'if a\n    endif|'],
    ['endif|', 'x', 'endifx|'],
    ['repeat\n  open until |', 'a', 'repeat\n  open until a|'],
    ['  if a\n  |', 'elseif b', '  if a\n  elseif b|'],
  ])('in %j typing %j', (before, keys, behind) => {
    expect(at(before, [...keys])).toBe(behind)
  })

  it('comes back where a closing word is taken back', () => {
    expect(at('if a\n  |', [...'end', 'Backspace', 'Backspace', 'Backspace', ...'open'])).toBe(
      'if a\n  open|',
    )
  })

  it('is left alone in what is pasted', () => {
    const state = emptyEditor('if a\n  ')
    const pasted = state.update(state.replaceSelection('endif\n   open'), { userEvent: 'input.paste' })
    expect(pasted.state.doc.toString()).toBe('if a\n  endif\n   open')
  })
})

describe('Enter in a text', () => {
  it.each([
    ['|', 'print "hi', 'print "hi"\n|'],
    ['|', 'print "hi, \\"', 'print "hi, \\""\n|'],
    ['repeat 3\n  |', 'print "', 'repeat 3\n  print ""\n  |'],
    ['print "|", n', 'a', 'print "a"\n|, n'],
    ['print "a|b"', '', 'print "a\n|b"'],
    ['print |"a"', '', 'print \n|"a"'],
    ['# 5|" wide', '', '# 5\n|" wide'],
  ])('in %j behind %j leaves the closing quote on its line', (before, keys, behind) => {
    expect(at(before, [...keys, 'Enter'])).toBe(behind)
  })

  it('leaves nothing below what is typed next', () => {
    expect(at('|', [...'print "hi', 'Enter', ...'mov home', 'Enter', ...'open'])).toBe(
      'print "hi"\nmov home\nopen|',
    )
  })
})

describe('brackets and quotes', () => {
  it.each([
    ['|', 'mov (1, [2], "a")', 'mov (1, [2], "a")|'],
    ['|', '# a ( b "', '# a ( b "|'],
    ['|', 'print "(" # "', 'print "(" # "|'],
    ['|', '"a \\" b"', '"a \\" b"|'],
    ['print "a|', '"', 'print "a"|'],
    ['task T\n  |', 'needs (open', 'task T\n  needs (open|'],
  ])('in %j typing %j', (before, keys, behind) => {
    expect(at(before, [...keys])).toBe(behind)
  })
})
