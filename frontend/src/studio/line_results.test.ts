import { expect, test } from 'vitest'
import { countsOf, lineResults, NO_RESULTS } from './line_results'

const LINES = [
  { line: 2, content: 'a' },
  { line: 4, content: 'b' },
]

test('a line is valid where its content is one of the run, else pending or stale', () => {
  expect([...lineResults(LINES, ['a'], 'run')]).toEqual([
    [3, 'valid'],
    [5, 'pending'],
  ])
  expect([...lineResults(LINES, ['a', 'c'], 'nothing')]).toEqual([
    [3, 'valid'],
    [5, 'stale'],
  ])
})

test('a text with errors has no valid line, and none that is computed', () => {
  const lines = [{ line: 2, content: '' }]
  expect([...lineResults(lines, [''], 'run')]).toEqual([[3, 'stale']])
})

test('a document of which there is no run has no marks', () => {
  expect(lineResults(LINES, undefined, 'run')).toBe(NO_RESULTS)
})

test('counts are those of the lines', () => {
  expect(countsOf(lineResults(LINES, ['a'], 'run'))).toEqual({ valid: 1, pending: 1, stale: 0 })
})
