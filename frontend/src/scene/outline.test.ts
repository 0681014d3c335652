import { BoxGeometry, SphereGeometry, Vector3 } from 'three'
import { describe, expect, it } from 'vitest'
import { outlineOf } from './outline'

describe('an outline', () => {
  it('of a box has its eight corners', () => {
    const points = outlineOf([new BoxGeometry(1, 2, 3)])
    expect(points).toHaveLength(8)
    for (const { x, y, z } of points) expect([x, y, z].map(Math.abs)).toEqual([0.5, 1, 1.5])
  })

  it('of a sphere reaches nearly as far as it everywhere, and not beyond', () => {
    const points = outlineOf([new SphereGeometry(1, 48, 24)])
    const direction = new Vector3(0.3, -0.8, 0.52).normalize()
    const reach = Math.max(...points.map(point => point.dot(direction)))
    expect(reach).toBeGreaterThan(0.9)
    expect(reach).toBeLessThanOrEqual(1)
  })

  it('of nothing is empty', () => {
    expect(outlineOf([])).toEqual([])
  })
})
