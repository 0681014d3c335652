import { Text } from '@codemirror/state'
import { describe, expect, it } from 'vitest'
import { closingLine, foldedBy } from './blocks'

const doc = Text.of([
  '1. Task "a"', // 1
  '  repeat 3', // 2
  '    if x then mov home', // 3
  '    repeat', // 4
  '    until x', // 5
  '    if x', // 6
  '    endif', // 7
  '  ENDR', // 8
  'endp', // 9
  'with frame pallet', // 10
  'task b', // 11
  'endtask', // 12
])

describe('blocks of a text', () => {
  it.each([
    [1, 9],
    [2, 8],
    [4, 5],
    [6, 7],
    [11, 12],
  ])('the block of line %i closes on line %i', (line, last) => {
    expect(closingLine(doc, line)).toBe(last)
  })

  it.each([3, 5, 9, 10])('line %i opens no block that closes', line => {
    expect(closingLine(doc, line)).toBeNull()
  })

  it('folds from the end of the opener to the closing word', () => {
    const fold = foldedBy(doc, 2)
    expect(doc.sliceString(0, fold?.from ?? 0).endsWith('repeat 3')).toBe(true)
    expect(doc.sliceString(fold?.to ?? 0).startsWith('ENDR')).toBe(true)
  })

  it('lets `end` close the innermost block', () => {
    const short = Text.of(['task a', 'for i = 1 to end', 'if x', 'end', 'end = 3', 'END. # i', 'end'])
    expect([1, 2, 3].map(line => closingLine(short, line))).toEqual([7, 6, 4])
  })
})
