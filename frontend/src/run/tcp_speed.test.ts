import { expect, test } from 'vitest'
import type { Series } from './run'
import { speedChannel, speedOf } from './tcp_speed'

const times = Float64Array.from({ length: 61 }, (_, k) => k / 60)
const along = (of: (time: number) => number): Series => ({ times, values: times.map(of), held: false })
const still: Series = { times: Float64Array.of(0, 1), values: Float64Array.of(0.3, 0.3), held: true }

test('a straight motion has the speed of its components', () => {
  const speed = speedOf([along(t => 0.3 * t), along(t => -0.4 * t), still])
  expect(speed?.values.every(value => Math.abs(value - 0.5) < 1e-9)).toBe(true)
})

test('a circular motion has the speed of its radius times its angular speed', () => {
  const speed = speedOf([along(t => 0.2 * Math.cos(2 * t)), along(t => 0.2 * Math.sin(2 * t)), still])
  const inside = speed?.values.subarray(1, -1) ?? new Float64Array(0)
  // Chords of a sixtieth of a second are shorter than their arcs by this share at most.
  expect(inside.every(value => Math.abs(value / 0.4 - 1) < 2e-4)).toBe(true)
})

test('frames that come in lumps tell the speed of an accelerated motion as it is', () => {
  const lumps = Float64Array.of(0, 0.016, 0.018, 0.09, 0.0901, 0.092, 0.15, 0.166)
  const x = {
    times: lumps,
    values: new Float64Array(new Float32Array(lumps.map(t => 0.5 + t * t))),
    held: false,
  }
  const speed = speedOf([x, still, still])?.values.subarray(1, -1) ?? new Float64Array(0)
  // Single precision leaves 6e-8 m, which over the least step is 3e-5 m/s.
  for (const [k, value] of speed.entries()) expect(value).toBeCloseTo(2 * (lumps[k + 1] ?? 0), 3)
})

test('a gap in the positions is a gap in the speed', () => {
  const speed = speedOf([along(t => (t > 0.5 ? Number.NaN : t)), still, still])
  expect(speed?.values[10]).toBeCloseTo(1)
  expect(speed?.values[50]).toBeNaN()
  expect(speedChannel('robot', speed).max[0]).toBeCloseTo(1)
})

test('without positions there is none', () => {
  expect(speedOf([undefined, still, still])).toBeUndefined()
})
