import { EditorState } from '@codemirror/state'
import { describe, expect, it } from 'vitest'
import { LineEnds } from './line_ends'

/** The text after edits, each replacing the first occurrence of a piece. */
function edited(text: string, ...edits: readonly [string, string][]): string {
  const ends = new LineEnds(text)
  let state = EditorState.create({ doc: text })
  for (const [piece, insert] of edits) {
    const from = state.doc.toString().indexOf(piece)
    const { changes, state: after } = state.update({ changes: { from, to: from + piece.length, insert } })
    ends.change(state.doc, after.doc, changes)
    state = after
  }
  return ends.text(state.doc)
}

describe('line ends', () => {
  it.each(['a\nb\n', 'a\r\nb\r\n', 'a\rb', 'a\r\nb\nc\rd', ''])('of %j come back as they were', text => {
    expect(edited(text)).toBe(text)
  })

  it('of untouched lines stay, new lines get the usual one', () => {
    expect(edited('a\r\nb\nc\r\nd', ['b', 'x\ny'])).toBe('a\r\nx\r\ny\nc\r\nd')
  })

  it('go with the lines that are joined', () => {
    expect(edited('a\r\nb\nc\rd', ['a\nb', 'ab'])).toBe('ab\nc\rd')
  })

  it('follow several edits', () => {
    expect(edited('a\nb\r\nc\r\n', ['c', 'c\nd'], ['a\n', ''], ['d', ''])).toBe('b\r\nc\r\n\r\n')
  })

  it('follow one edit in several places', () => {
    const ends = new LineEnds('a\nb\r\nc\nd')
    const state = EditorState.create({ doc: 'a\nb\r\nc\nd' })
    const { changes, state: after } = state.update({
      changes: [
        { from: 0, insert: 'x\n' },
        { from: 4, to: 6, insert: '' },
      ],
    })
    ends.change(state.doc, after.doc, changes)
    expect(after.doc.toString()).toBe('x\na\nb\nd')
    expect(ends.text(after.doc)).toBe('x\na\nb\r\nd')
  })
})
