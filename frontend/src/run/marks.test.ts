import { describe, expect, it } from 'vitest'
import { firstAfter, lastBefore, marksOf, nearest, stepAt, worstLast } from './marks'
import type { Run } from './run'

const span = { source: 'main.task', line: 4, column: 1, end_line: 4, end_column: 9 }
const event = (time: number, kind: string) => ({
  time,
  duration: 0.5,
  kind,
  text: kind,
  station: '',
  span,
  data: {},
})

const run = {
  events: [
    event(2, 'move'),
    event(0, 'task'),
    event(1, 'grip'),
    { ...event(3, 'output'), span: null },
    { ...event(1.5, 'input'), text: 'start = 0', span: null },
    { ...event(0.5, 'input'), text: 'start = 1', span: null },
  ],
  findings: [
    { code: 'S720', severity: 'warning', message: 'late', hint: '', span, time: 2.25 },
    { code: 'N205', severity: 'error', message: 'unknown', hint: '', span, time: null },
  ],
} as unknown as Run

describe('marks', () => {
  it('are the steps of the program in order of time, without tasks', () => {
    expect(marksOf(run).steps.map(step => [step.time, step.end, step.kind, step.line])).toEqual([
      [1, 1.5, 'grip', 4],
      [2, 2.5, 'move', 4],
    ])
  })

  it('hold only findings that have a time', () => {
    expect(marksOf(run).findings).toEqual([{ time: 2.25, severity: 'warning', text: 'S720 late' }])
  })

  it('tell the worst of the findings of a time', () => {
    const found = (severity: string) => ({ code: 'S1', severity, message: severity, hint: '', span, time: 2 })
    const both = { ...run, findings: [found('error'), found('hint')] } as unknown as Run
    expect(nearest(marksOf(both).findings, 2, 0.1)?.severity).toBe('error')
  })

  it('hold the inputs that were set from outside, which belong to no line', () => {
    expect(marksOf(run).inputs).toEqual([
      { time: 0.5, text: 'start = 1' },
      { time: 1.5, text: 'start = 0' },
    ])
  })

  it('are drawn with the worst on top, wherever they are', () => {
    const mark = (time: number, severity: 'error' | 'warning' | 'info' | 'hint') => ({
      time,
      severity,
      text: '',
    })
    const marks = [
      mark(1, 'error'),
      mark(1.1, 'hint'),
      mark(1.2, 'warning'),
      mark(1.3, 'info'),
      mark(2, 'error'),
    ]
    expect(worstLast(marks).map(one => one.time)).toEqual([1.1, 1.3, 1.2, 1, 2])
  })

  it('are stepped over one by one, never staying at the same time', () => {
    const { steps } = marksOf(run)
    expect(firstAfter(steps, 0)?.time).toBe(1)
    expect(firstAfter(steps, 1)?.time).toBe(2)
    expect(firstAfter(steps, 2)).toBeUndefined()
    expect(lastBefore(steps, 2)?.time).toBe(1)
    expect(lastBefore(steps, 1)).toBeUndefined()
  })

  it('know the step that runs', () => {
    expect(stepAt(marksOf(run), 0.5)).toBeUndefined()
    expect(stepAt(marksOf(run), 1)?.kind).toBe('grip')
    expect(stepAt(marksOf(run), 9)?.kind).toBe('move')
  })

  it('are found within reach only', () => {
    const { findings } = marksOf(run)
    expect(nearest(findings, 2.2, 0.1)?.time).toBe(2.25)
    expect(nearest(findings, 2, 0.1)).toBeUndefined()
  })
})
