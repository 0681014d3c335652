import { describe, expect, it } from 'vitest'
import { tickLabel, tickStep, ticks } from './ticks'

describe('ticks of the scale', () => {
  it('stand at round times with room for their words', () => {
    expect(tickStep(10, 60)).toBe(10)
    expect(tickStep(4, 60)).toBe(20)
    expect(tickStep(1.3, 60)).toBe(50)
    expect(tickStep(1000, 60)).toBeCloseTo(0.1)
    expect(tickStep(0, 60)).toBe(Number.POSITIVE_INFINITY)
  })

  it('begin and end inside', () => {
    expect(ticks(3, 21, 5)).toEqual([5, 10, 15, 20])
    expect(ticks(0, 10, 5)).toEqual([0, 5, 10])
    expect(ticks(0, 10, Number.POSITIVE_INFINITY)).toEqual([])
  })

  it('are written with the decimals that they need', () => {
    expect(tickLabel(20, 10)).toBe('20')
    expect(tickLabel(0.30000000000000004, 0.1)).toBe('0.3')
    expect(tickLabel(1.25, 0.05)).toBe('1.25')
  })
})
