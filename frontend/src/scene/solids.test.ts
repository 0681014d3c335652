import { describe, expect, it } from 'vitest'
import { box, prism } from './prism'
import { cylinder, revolve, sphere } from './revolve'
import { type Solid, volume } from './solid'

/** Least and greatest coordinates. */
function bounds({ positions }: Solid): [number[], number[]] {
  const axis = (k: number) => positions.filter((_, i) => i % 3 === k)
  return [[0, 1, 2].map(k => Math.min(...axis(k))), [0, 1, 2].map(k => Math.max(...axis(k)))]
}

/** Smallest cosine between the normal of a triangle and the normals at its corners. */
function worstNormal({ positions, normals, indices }: Solid): number {
  const at = (a: number[], i: number) => [a[3 * i] ?? 0, a[3 * i + 1] ?? 0, a[3 * i + 2] ?? 0] as const
  let worst = 1
  for (let k = 0; k < indices.length; k += 3) {
    const corners = [indices[k] ?? 0, indices[k + 1] ?? 0, indices[k + 2] ?? 0]
    const [a, b, c] = corners.map(i => at(positions, i))
    if (!a || !b || !c) throw new Error('no triangle')
    const [u, v] = [b.map((x, i) => x - (a[i] ?? 0)), c.map((x, i) => x - (a[i] ?? 0))]
    const [ux = 0, uy = 0, uz = 0] = u
    const [vx = 0, vy = 0, vz = 0] = v
    const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx]
    const length = Math.hypot(...n)
    for (const i of corners) {
      const m = at(normals, i)
      expect(Math.hypot(...m)).toBeCloseTo(1, 9)
      worst = Math.min(worst, (m[0] * (n[0] ?? 0) + m[1] * (n[1] ?? 0) + m[2] * (n[2] ?? 0)) / length)
    }
  }
  return worst
}

const L_OUTLINE = [
  [0, 0],
  [2, 0],
  [2, 1],
  [1, 1],
  [1, 3],
  [0, 3],
] as const

describe('surfaces of shapes', () => {
  it('a box fills its size about the origin', () => {
    const solid = box([0.4, 0.6, 0.2])
    expect(bounds(solid)).toEqual([
      [-0.2, -0.3, -0.1],
      [0.2, 0.3, 0.1],
    ])
    expect(volume(solid)).toBeCloseTo(0.048, 12)
    expect(worstNormal(solid)).toBeCloseTo(1, 12)
    expect(solid.creases.length / 6).toBe(12)
  })

  it('a prism keeps the area of an outline with a notch, whatever its sense', () => {
    for (const outline of [L_OUTLINE, [...L_OUTLINE].reverse()]) {
      const solid = prism(outline, 0.5)
      expect(volume(solid)).toBeCloseTo(2, 12)
      expect(bounds(solid)[0]?.[2]).toBe(0)
      expect(worstNormal(solid)).toBeCloseTo(1, 12)
    }
  })

  it('round walls of a prism are smooth, its corners are not', () => {
    const round = Array.from({ length: 48 }, (_, k) => [Math.cos(k * 0.1309), Math.sin(k * 0.1309)] as const)
    const solid = prism(round, 1)
    expect(worstNormal(solid)).toBeLessThan(0.9999)
    expect(worstNormal(solid)).toBeGreaterThan(0.99)
    expect(solid.creases.length / 6).toBe(2 * 48)
    expect(prism(L_OUTLINE, 1).creases.length / 6).toBe(3 * 6)
  })

  it('a cylinder, a cone and a frustum hold what they should', () => {
    const full = (r: number, t: number) => (Math.PI * (r * r + r * t + t * t)) / 3
    for (const [radius, top] of [
      [0.3, 0.3],
      [0.3, 0],
      [0, 0.3],
      [0.3, 0.1],
    ] as const) {
      const solid = cylinder(radius, top, 1)
      // Inscribed chords lose 2/3·(π/n)² of the area; n is 48 at most and 40 here.
      expect(volume(solid) / full(radius, top)).toBeGreaterThan(0.995)
      expect(volume(solid) / full(radius, top)).toBeLessThan(1)
      expect(worstNormal(solid)).toBeGreaterThan(0.99)
      expect(bounds(solid)[0]?.[2]).toBe(-0.5)
      expect(bounds(solid)[1]?.[2]).toBe(0.5)
    }
  })

  it('a sphere is closed, round and smooth all over', () => {
    const solid = sphere(0.2)
    expect(volume(solid) / ((4 / 3) * Math.PI * 0.008)).toBeGreaterThan(0.985)
    expect(solid.creases).toEqual([])
    solid.positions.forEach((_, i) => {
      if (i % 3) return
      const [x = 0, y = 0, z = 0] = solid.positions.slice(i, i + 3)
      expect(Math.hypot(x, y, z)).toBeCloseTo(0.2, 9)
    })
    expect(worstNormal(solid)).toBeGreaterThan(0.98)
  })

  it('a profile turned the other way round is turned outside out', () => {
    const ring = [
      [0.1, 0],
      [0.2, 0],
      [0.2, 0.1],
      [0.1, 0.1],
      [0.1, 0],
    ] as const
    for (const profile of [ring, [...ring].reverse()]) {
      const solid = revolve(profile)
      expect(volume(solid) / (Math.PI * 0.03 * 0.1)).toBeGreaterThan(0.99)
      expect(worstNormal(solid)).toBeGreaterThan(0.99)
      expect(solid.open).toBe(false)
      expect(solid.creases.length % 6).toBe(0)
    }
  })

  it('an open profile is seen from both sides', () => {
    expect(
      revolve([
        [0.1, 0],
        [0.2, 0.3],
      ]).open,
    ).toBe(true)
    expect(
      revolve([
        [0, 0],
        [0.2, 0.1],
        [0, 0.3],
      ]).open,
    ).toBe(false)
  })
})
