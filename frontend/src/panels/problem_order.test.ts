import { describe, expect, it } from 'vitest'
import type { Problem } from '../studio/problems'
import { matching, neighbour } from './problem_order'

function problem(document: string, line: number, column: number, message = ''): Problem {
  const rest = {
    endLine: line,
    endColumn: column + 1,
    severity: 'error',
    code: 'N201',
    hint: '',
    time: null,
  } as const
  return { document, line, column, message, ...rest }
}

const A = problem('a.task', 3, 1, 'Task not defined')
const B = problem('a.task', 3, 9)
const C = problem('b.task', 1, 1)
const NOWHERE = problem('', 0, 0, 'no cell')
const ALL = [C, NOWHERE, B, A]

describe('going through problems', () => {
  it.each([
    ['a.task', 1, 1, 'next', A],
    ['a.task', 3, 1, 'next', B],
    ['a.task', 3, 9, 'next', C],
    ['b.task', 1, 1, 'next', A],
    ['a.task', 3, 1, 'previous', C],
    ['b.task', 1, 1, 'previous', B],
  ] as const)('from %s %i:%i to the %s one', (document, line, column, direction, wanted) => {
    expect(neighbour(ALL, { document, line, column }, direction)).toBe(wanted)
  })

  it('leads nowhere where no problem has a place', () => {
    expect(neighbour([NOWHERE], { document: 'a.task', line: 1, column: 1 }, 'next')).toBeUndefined()
  })
})

describe('filtering problems', () => {
  it('asks for all words in any case', () => {
    expect(matching(ALL, 'TASK n201')).toEqual([C, B, A])
    expect(matching(ALL, 'defined task')).toEqual([A])
    expect(matching(ALL, ' ')).toBe(ALL)
  })
})
