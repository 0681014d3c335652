import { describe, expect, it } from 'vitest'
import { essentialPoints, TOLERANCE } from './thin_path'

function path(count: number, at: (k: number) => readonly [number, number, number]): Float32Array {
  return Float32Array.from(Array.from({ length: count }, (_, k) => at(k)).flat())
}

/** Greatest distance of the whole path from the thinned one. */
function deviation(points: Float32Array, kept: Uint32Array): number {
  const at = (k: number) => [...points.subarray(3 * k, 3 * k + 3)]
  let most = 0
  for (let piece = 1; piece < kept.length; piece++) {
    const [from, to] = [kept[piece - 1] ?? 0, kept[piece] ?? 0]
    const [a, b] = [at(from), at(to)]
    for (let k = from; k <= to; k++) {
      const p = at(k)
      let nearest = Number.POSITIVE_INFINITY
      for (let share = 0; share <= 1; share += 0.001) {
        nearest = Math.min(
          nearest,
          Math.hypot(...p.map((one, c) => one - (a[c] ?? 0) - share * ((b[c] ?? 0) - (a[c] ?? 0)))),
        )
      }
      most = Math.max(most, nearest)
    }
  }
  return most
}

describe('a thinned path', () => {
  it('keeps first and last, and the corner of two straight lines', () => {
    const corner = path(61, k => (k <= 30 ? [0.01 * k, 0, 0] : [0.3, 0.01 * (k - 30), 0]))
    expect([...essentialPoints(corner, 61)]).toEqual([0, 30, 60])
  })

  it('needs few points where the tool stands', () => {
    expect(essentialPoints(new Float32Array(3 * 600), 600).length).toBeLessThan(25)
  })

  it('turns back where the tool does', () => {
    const there = path(41, k => [0.01 * (k <= 20 ? k : 40 - k), 0, 0])
    expect([...essentialPoints(there, 41)]).toEqual([0, 20, 40])
  })

  it('stays within the tolerance of a curve, with far fewer points', () => {
    const circle = path(400, k => [0.5 * Math.cos(k / 200), 0.5 * Math.sin(k / 200), k / 1000])
    const kept = essentialPoints(circle, 400)
    expect(kept.length).toBeLessThan(60)
    expect(deviation(circle, kept)).toBeLessThanOrEqual(1.01 * TOLERANCE)
  })

  it('is as short as a path can be', () => {
    expect([...essentialPoints(new Float32Array(0), 0)]).toEqual([])
    expect([...essentialPoints(new Float32Array(3), 1)]).toEqual([0])
    expect([...essentialPoints(new Float32Array(6), 2)]).toEqual([0, 1])
  })
})
