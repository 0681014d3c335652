import { describe, expect, it } from 'vitest'
import type { Run } from '../run/run'
import { nextPass, stepsByLine } from './steps'

const step = (time: number, line: number, source = 'main.task', kind = 'move', station = 'left') => ({
  time,
  duration: 1,
  kind,
  text: '',
  span: { source, line, column: 1, end_line: line, end_column: 1 },
  station,
  data: {},
})
const events = [
  step(4, 7),
  step(1, 7),
  step(2, 8),
  step(3, 7, 'other.task'),
  step(0, 7, 'main.task', 'task'),
  step(5, 7, 'main.task', 'move', 'right'),
]
const steps = stepsByLine({ events } as unknown as Run, 'main.task', 'left')

describe('steps of a line', () => {
  it('are those of its text and station, in order of time, without tasks', () => {
    expect([...steps.keys()].sort()).toEqual([7, 8])
    expect(steps.get(7)?.map(one => one.time)).toEqual([1, 4])
  })

  it('are gone through one after the other, then from the first again', () => {
    const passes = steps.get(7) ?? []
    expect(nextPass(passes, 0)).toBe(0)
    expect(nextPass(passes, 1)).toBe(1)
    expect(nextPass(passes, 4)).toBe(0)
  })
})
