import { BoxGeometry, Group, Mesh, MeshStandardMaterial } from 'three'
import { describe, expect, it } from 'vitest'
import { FrameTimes } from './frame_times'
import { rectsOf } from './layouts'
import { meshData } from './mesh_data'
import { LAYOUTS } from './settings'
import { volume } from './solid'
import { bridgeGaps, countUntil, placeAt } from './trail_line'

describe('layouts', () => {
  it.each(LAYOUTS)('%s: viewports lie inside the stage, do not overlap and leave only thin gaps', layout => {
    const rects = rectsOf(layout, 1281, 799)
    let area = 0
    rects.forEach((a, i) => {
      expect(a.x >= 0 && a.y >= 0 && a.x + a.width <= 1281 && a.y + a.height <= 799).toBe(true)
      area += a.width * a.height
      for (const b of rects.slice(i + 1)) {
        const apart =
          a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y
        expect(apart).toBe(true)
      }
    })
    expect(area / (1281 * 799)).toBeGreaterThan(0.99)
  })

  it('is that of one viewport where four would be too low', () => {
    expect(rectsOf('4', 388, 171)).toHaveLength(1)
    expect(rectsOf('4', 388, 211)).toHaveLength(4)
  })

  it.each(LAYOUTS)('%s: one viewport has all of a low stage', layout => {
    expect(rectsOf(layout, 388, 90)).toEqual([{ x: 0, y: 0, width: 388, height: 90 }])
  })
})

describe('a path', () => {
  it('is passed up to and including a time', () => {
    const times = Float64Array.from([0, 1, 1, 2])
    expect([-1, 0, 0.5, 1, 2, 9].map(time => countUntil(times, time))).toEqual([0, 1, 1, 3, 4, 4])
  })

  it('reaches to the very place of a time', () => {
    const trail = {
      times: Float64Array.from([1, 2, 4]),
      points: Float32Array.from([0, 0, 0, 1, 2, 3, 1, 2, 5]),
    }
    expect([0, 1, 1.5, 3, 4, 9, Number.POSITIVE_INFINITY].map(time => [...placeAt(trail, time)])).toEqual([
      [0, 0, 0],
      [0, 0, 0],
      [0.5, 1, 1.5],
      [1, 2, 4],
      [1, 2, 5],
      [1, 2, 5],
      [1, 2, 5],
    ])
  })

  it('stays where it was while there is no position', () => {
    const points = Float32Array.from([
      Number.NaN,
      Number.NaN,
      Number.NaN,
      1,
      2,
      3,
      Number.NaN,
      Number.NaN,
      Number.NaN,
    ])
    bridgeGaps(points, 9)
    expect([...points]).toEqual([1, 2, 3, 1, 2, 3, 1, 2, 3])
    const never = new Float32Array(6).fill(Number.NaN)
    bridgeGaps(never, 6)
    expect([...never]).toEqual([0, 0, 0, 0, 0, 0])
  })
})

describe('frame times', () => {
  it('tell quantiles of the last 300', () => {
    const times = new FrameTimes()
    expect(times.quantile(0.5)).toBe(0)
    for (let k = 0; k < 1000; k++) times.add(k)
    expect(times.count).toBe(1000)
    expect(times.quantile(0.5)).toBe(850)
    expect(times.quantile(0.95)).toBe(985)
    expect(times.quantile(1)).toBe(999)
  })
})

describe('a mesh of a file', () => {
  const place = (material: MeshStandardMaterial) => {
    const mesh = new Mesh(new BoxGeometry(0.1, 0.2, 0.3), material)
    mesh.position.set(1, 0, 0)
    const root = new Group()
    root.scale.setScalar(2)
    root.add(mesh)
    return meshData(root)
  }

  it('comes with all transforms applied', () => {
    const data = place(new MeshStandardMaterial())
    expect(volume({ ...data, contours: [], open: true })).toBeCloseTo(0.048, 6)
    expect(Math.min(...data.positions.filter((_, k) => k % 3 === 0))).toBeCloseTo(1.9, 6)
    expect(data.creases.length / 6).toBe(12)
  })

  it('has colours only where the file gives some', () => {
    expect(place(new MeshStandardMaterial()).colours).toBeUndefined()
    expect(place(new MeshStandardMaterial({ color: '#ff0000' })).colours?.slice(0, 3)).toEqual([1, 0, 0])
  })
})
