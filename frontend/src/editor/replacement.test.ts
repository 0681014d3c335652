import { EditorState } from '@codemirror/state'
import { describe, expect, it, test } from 'vitest'
import { replacements } from './replacement'
import { dice } from './typist'

function replaced(before: string, after: string, head = 0): EditorState {
  const state = EditorState.create({ doc: before, selection: { anchor: head } })
  return state.update({ changes: replacements(before, after) as never }).state
}

describe('what makes one text of another', () => {
  it.each([
    ['mov a', 'mov b'],
    ['aaa', 'aa'],
    ['', 'x'],
    ['abcabc', 'abc'],
    ['x', ''],
    ['a\nb\nc', 'b\nc\na\n'],
    ['a\n\n\nb', '\na\n\nb\n\n'],
  ])('turns %j into %j', (before, after) => {
    expect(replaced(before, after).doc.toString()).toBe(after)
  })

  it('are the letters that differ', () => {
    expect(replacements('lin infeed', 'lin outfeed')).toEqual([{ from: 4, to: 6, insert: 'out' }])
    expect(replacements('# one\nmov a\nopen\nmov b\n', '# two\nmov a\nopen\nlin b\n')).toEqual([
      { from: 2, to: 5, insert: 'two' },
      { from: 17, to: 20, insert: 'lin' },
    ])
  })

  it('are none for the same text', () => {
    expect(replacements('a\n', 'a\n')).toEqual([])
  })
})

test('a cursor on a line that stays keeps its place there, whatever changes above and below', () => {
  const roll = dice(7)
  for (let time = 0; time < 500; time += 1) {
    const lines = Array.from({ length: 2 + roll(12) }, (_, at) => (roll(3) ? `mov p${at}` : 'open'))
    const mine = roll(lines.length)
    lines[mine] = 'lin here'
    const column = 1 + roll(7)
    const change = (part: string[]) =>
      part.flatMap(
        line => [[line], [], [line, 'close'], [`${line} fine`], ['wait 1 s', line]][roll(8)] ?? [line],
      )
    const above = change(lines.slice(0, mine))
    const after = [...above, 'lin here', ...change(lines.slice(mine + 1))].join('\n')
    const head = lines.slice(0, mine).join('\n').length + (mine ? 1 : 0) + column
    const state = replaced(lines.join('\n'), after, head)
    expect(state.doc.toString()).toBe(after)
    const line = state.doc.lineAt(state.selection.main.head)
    expect([line.text, state.selection.main.head - line.from]).toEqual(['lin here', column])
  }
})

test('takes no longer than the texts are long, whatever stands there', () => {
  const same = 'open\n'.repeat(20_000)
  expect(replaced(same, `${same}mov a\n${same}`).doc.lines).toBe(40_002)
  const lines = Array.from({ length: 20_000 }, (_, at) => `n = ${at}\n`)
  expect(replaced(lines.join(''), [...lines].reverse().join('')).doc.line(1).text).toBe('n = 19999')
})
