import { expect, test } from 'vitest'
import { belowCauses, grouped, nextOf } from './problem_groups'
import type { Problem } from './problems'

const PROBLEM: Problem = {
  document: 'programs/main.task',
  line: 4,
  column: 2,
  endLine: 4,
  endColumn: 5,
  severity: 'warning',
  code: 'S720',
  message: 'joint `2` is 0.2° from its target',
  hint: '',
  time: 3,
}

const later = { ...PROBLEM, message: 'joint `2` is 0.3° from its target', time: 9 }

test('the same finding on the same line is one row, however often and with whatever numbers', () => {
  const [group, ...others] = grouped([later, PROBLEM])
  expect(others).toEqual([])
  expect(group?.first).toBe(PROBLEM)
  expect(group?.all).toEqual([PROBLEM, later])
})

test.each([
  ['line', { line: 5 }],
  ['document', { document: 'cell.toml' }],
  ['code', { code: 'S721' }],
  ['severity', { severity: 'error' }],
  ['reason', { message: 'joint `2` stands still' }],
] as const)('another %s is another row', (_, change) => {
  expect(grouped([PROBLEM, { ...PROBLEM, ...change }])).toHaveLength(2)
})

test('findings without a line are told apart by their words', () => {
  const nowhere = { ...PROBLEM, line: 0 }
  expect(grouped([nowhere, { ...nowhere, time: 5 }, { ...nowhere, message: 'another' }])).toHaveLength(2)
})

test('going through a row leads from time to time and round', () => {
  const [group] = grouped([PROBLEM, later])
  if (!group) throw new Error('there must be a group')
  expect([0, 3, 8.9, 9, 20].map(time => nextOf(group, time).time)).toEqual([3, 9, 9, 3, 3])
})

test('what likely follows from a line stands behind what was found there', () => {
  const cause = { ...PROBLEM, line: 12, code: 'M564' }
  const follows = { document: PROBLEM.document, line: 12 }
  const grip = { ...PROBLEM, line: 13, code: 'S721', follows }
  const astray = { ...PROBLEM, line: 0, document: '', code: 'S738', follows }
  const lost = { ...grip, line: 14, follows: { ...follows, line: 99 } }
  const told = belowCauses(grouped([astray, grip, cause, lost, PROBLEM])).map(one => one.first)
  expect(told).toEqual([cause, astray, grip, PROBLEM, lost])
})
