import { Text } from '@codemirror/state'
import { expect, test } from 'vitest'
import type { Problem } from '../studio/problems'
import { foundMarks } from './found_marks'

const DOC = Text.of(['program p', '  mov a # far', ''])
const PROBLEM: Problem = {
  document: 'programs/main.task',
  line: 2,
  column: 1,
  endLine: 2,
  endColumn: 1,
  severity: 'error',
  code: 'M1',
  message: 'too far',
  hint: 'nearer',
  time: 3,
}

test('a finding of a line is under its words, with its hint', () => {
  const [mark, ...others] = foundMarks([PROBLEM], DOC)
  expect(others).toEqual([])
  expect(DOC.sliceString(mark?.from ?? 0, mark?.to)).toBe('mov a # far')
  expect([mark?.message, mark?.source, mark?.severity]).toEqual(['too far\nnearer', 'M1', 'error'])
})

test('a finding of some words is under these', () => {
  const [mark] = foundMarks([{ ...PROBLEM, column: 3, endColumn: 6 }], DOC)
  expect(DOC.sliceString(mark?.from ?? 0, mark?.to)).toBe('mov')
})

test('the same finding of many passes is one mark that counts them', () => {
  const marks = foundMarks([PROBLEM, { ...PROBLEM, time: 9 }], DOC)
  expect(marks.map(one => one.message)).toEqual(['too far\nnearer\n2 times on this line'])
})

test('findings beyond the text are not marked', () => {
  expect(
    foundMarks(
      [
        { ...PROBLEM, line: 9, endLine: 9 },
        { ...PROBLEM, line: 0 },
      ],
      DOC,
    ),
  ).toEqual([])
})
