import { expect, test } from 'vitest'
import type { Series } from '../run/run'
import { decimate, lowerBound } from './decimate'
import { joinPoints } from './table'

function series(count: number, value: (at: number) => number): Series {
  return {
    times: Float64Array.from({ length: count }, (_, at) => at / 60),
    values: Float64Array.from({ length: count }, (_, at) => value(at)),
    held: false,
  }
}

test('a long series becomes at most a few points for each pixel', () => {
  const { times } = decimate(series(60_000, Math.sin), 0, 1000, 500)
  expect(times.length).toBeLessThanOrEqual(5 * 501)
  expect(times.length).toBeGreaterThan(500)
})

test('the highest and the lowest peak stay, however short', () => {
  const spiky = series(60_000, at => (at === 31_234 ? 9 : at === 40_001 ? -7 : Math.sin(at)))
  const { times, values } = decimate(spiky, 0, 1000, 300)
  expect(Math.max(...values)).toBe(9)
  expect(Math.min(...values)).toBe(-7)
  expect(times[values.indexOf(9)]).toBe(31_234 / 60)
})

test('times stay in order and ends stay ends', () => {
  const { times } = decimate(series(10_000, Math.cos), 0, 10_000 / 60, 100)
  expect([...times]).toEqual([...times].sort((a, b) => a - b))
  expect(times[0]).toBe(0)
  expect(times.at(-1)).toBe(9999 / 60)
})

test('a gap of one sample stays a gap', () => {
  const { values } = decimate(
    series(10_000, at => (at === 5003 ? Number.NaN : 1)),
    0,
    10_000 / 60,
    100,
  )
  expect([...values].filter(Number.isNaN)).toHaveLength(1)
})

test('zoomed in, every sample is there, and one beyond on each side', () => {
  const { times } = decimate(
    series(6000, at => at),
    10.01,
    10.99,
    500,
  )
  expect(times[0]).toBeLessThanOrEqual(10.01)
  expect(times.at(-1)).toBeGreaterThanOrEqual(10.99)
  expect(times.length).toBeLessThanOrEqual(62)
})

test('the bound is the first time that is not below', () => {
  const times = Float64Array.of(0, 1, 1, 2)
  expect([0, 0.5, 1, 2, 3].map(time => lowerBound(times, time))).toEqual([0, 1, 1, 3, 4])
})

test('series of different times share one axis; gaps break lines, absent samples do not', () => {
  const a = { times: Float64Array.of(0, 1, 2), values: Float64Array.of(5, Number.NaN, 7) }
  const b = { times: Float64Array.of(0.5, 2), values: Float64Array.of(1, 2) }
  const { times, columns } = joinPoints([a, b], [1, 10])
  expect(times).toEqual([0, 0.5, 1, 2])
  expect(columns[0]).toEqual([5, undefined, null, 7])
  expect(columns[1]).toEqual([undefined, 10, undefined, 20])
})
