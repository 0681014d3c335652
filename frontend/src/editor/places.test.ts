import { ChangeSet, Text } from '@codemirror/state'
import { describe, expect, test } from 'vitest'
import { type Action, changesBy } from './actions_panel'
import { changesOf, offsetOf } from './places'
import { decorations } from './same_name'

const doc = Text.of(['loc a', 'lin a', ''])
const range = (line: number, start: number, endLine: number, end: number) => ({
  start: { line, character: start },
  end: { line: endLine, character: end },
})

describe('places of the protocol', () => {
  test('are offsets of the text, at most the end of their line', () => {
    expect(offsetOf(doc, { line: 1, character: 2 })).toBe(8)
    expect(offsetOf(doc, { line: 0, character: 99 })).toBe(5)
    expect(offsetOf(doc, { line: 3, character: 0 })).toBe(doc.length)
    expect(offsetOf(doc, { line: 4, character: 0 })).toBeNull()
  })

  test('of edits are changes, of which an insertion may stand before a replacement', () => {
    const edits = [
      { range: range(1, 0, 1, 0), newText: 'task T\nendp\n' },
      { range: range(1, 0, 1, 5), newText: 'T' },
    ]
    const changes = changesOf(doc, edits)
    expect(changes).not.toBeNull()
    const after = ChangeSet.of([...(changes ?? [])], doc.length).apply(doc)
    expect(after.toString()).toBe('loc a\ntask T\nendp\nT\n')
  })

  test('beyond the text make no change', () => {
    expect(changesOf(doc, [{ range: range(7, 0, 7, 1), newText: '' }])).toBeNull()
  })
})

describe('actions', () => {
  const edits = [{ range: range(1, 4, 1, 5), newText: 'b' }]

  test('change the text that they are about', () => {
    const action: Action = { title: 'x', edit: { changes: { 'file:///x': edits } } }
    expect(changesBy(action, 'file:///x', doc)).toEqual([{ from: 10, to: 11, insert: 'b' }])
    expect(changesBy(action, 'file:///y', doc)).toBeNull()
  })

  test('that are refused change nothing', () => {
    expect(changesBy({ title: 'x', disabled: { reason: 'no' } }, 'file:///x', doc)).toBeNull()
  })
})

test('names at the cursor are marked, and where they are given a value', () => {
  const found = decorations(doc, [
    { range: range(0, 4, 0, 5), kind: 3 },
    { range: range(1, 4, 1, 5), kind: 2 },
    { range: range(9, 0, 9, 1), kind: 2 },
  ])
  const marked: [number, number, string][] = []
  found.between(0, doc.length, (from, to, mark) => {
    marked.push([from, to, mark.spec.class])
  })
  expect(marked).toEqual([
    [4, 5, 'cm-name cm-name-written'],
    [10, 11, 'cm-name'],
  ])
})
