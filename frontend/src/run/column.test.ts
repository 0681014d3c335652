import { describe, expect, it } from 'vitest'
import { Clock, Column, smoothValues } from './column'

const clock = new Clock(60, 0.05, 4)
const none = new Uint8Array(0)

describe('a smooth column', () => {
  it('is summed up twice from zigzag numbers of seven bits a byte', () => {
    // 0, 100, 200, 300: differences 0, 100, 0, 0 → zigzag 0, 200, 0, 0 → 200 is c8 01
    expect([...smoothValues(Uint8Array.of(0, 0xc8, 1, 0, 0), 4, 0.5)]).toEqual([0, 50, 100, 150])
  })

  it('reads numbers longer than 32 bits', () => {
    const bytes = [0x80, 0x80, 0x80, 0x80, 0x80, 0x20] // 2^40, zigzag of 2^39
    expect(smoothValues(Uint8Array.from(bytes), 1, 1)[0]).toBe(2 ** 39)
  })

  it('that is cut off is refused', () => {
    expect(() => smoothValues(Uint8Array.of(0, 0x80), 2, 1)).toThrow('cut off')
  })

  it('is linear in between, ends at the end of the run, and has no value in gaps', () => {
    const bytes = Uint8Array.of(0, 4, 0, 0) // 0, 2, 4, 6
    const code = { kind: 'smooth', step: 1, offset: 0, length: 4, gaps: [] } as const
    const column = new Column(code, bytes, clock)
    expect(column.value(1.5 / 60)).toBeCloseTo(3, 12)
    expect(column.value(0.05)).toBe(6)
    const gap = new Column({ ...code, gaps: [[1, 2]] }, bytes, clock)
    expect(gap.value(0)).toBe(0)
    expect(gap.value(0.5 / 60)).toBeNaN()
    expect(gap.value(2 / 60)).toBe(4)
  })
})

describe('other columns', () => {
  it('hold their value until the exact time of the next', () => {
    const code = { kind: 'steps', times: [0, 0.02], values: [1, null] } as const
    const column = new Column(code, none, clock)
    expect(column.value(0.019999)).toBe(1)
    expect(column.value(0.02)).toBeNaN()
    expect(column.series.held).toBe(true)
  })

  it('may be constant', () => {
    const column = new Column({ kind: 'constant', value: 7 }, none, clock)
    expect([column.value(0), column.value(9)]).toEqual([7, 7])
    expect([...column.series.times]).toEqual([0, 0.05])
  })
})

describe('the clock of a pack', () => {
  it('has its last sample at the end of the run', () => {
    const odd = new Clock(60, 0.04, 4)
    expect([...odd.times]).toEqual([0, 1 / 60, 2 / 60, 0.04])
    expect(odd.locate(0.04)).toEqual({ index: 2, share: 1 })
  })

  it('knows a run of no length', () => {
    expect(new Clock(60, 0, 1).locate(3)).toEqual({ index: 0, share: 0 })
  })
})
