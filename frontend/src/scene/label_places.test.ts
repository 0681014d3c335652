import { describe, expect, it } from 'vitest'
import { arrange, type Wanted } from './label_places'

const size = { width: 400, height: 300 }
const name = (x: number, y: number, rank = 0): Wanted => ({ x, y, width: 50, height: 16, rank })

describe('names in a picture', () => {
  it('stand to the lower right of their points', () => {
    expect(arrange([name(100, 100)], size)).toEqual([{ left: 106, top: 104 }])
  })

  it('never lie upon each other, whatever is asked', () => {
    const wanted = Array.from({ length: 200 }, (_, k) => name((k * 37) % 400, (k * 91) % 300, k % 5))
    const rects = arrange(wanted, size).flatMap(spot => (spot ? [spot] : []))
    expect(rects.length).toBeGreaterThan(20)
    rects.forEach((a, i) => {
      expect(a.left >= 0 && a.top >= 0 && a.left + 50 <= 400 && a.top + 16 <= 300).toBe(true)
      for (const b of rects.slice(i + 1)) {
        expect(Math.abs(a.left - b.left) >= 50 || Math.abs(a.top - b.top) >= 16).toBe(true)
      }
    })
  })

  it('at one point stand around it, and the least important of five is left out', () => {
    const spots = arrange(
      [4, 0, 3, 1, 2].map(rank => name(200, 150, rank)),
      size,
    )
    expect(spots[0]).toBeNull()
    expect(spots.filter(spot => spot !== null)).toHaveLength(4)
    expect(spots[1]).toEqual({ left: 206, top: 154 })
  })

  it('turn inwards at the edge of the picture', () => {
    expect(arrange([name(390, 290)], size)).toEqual([{ left: 334, top: 270 }])
  })

  it('leave free what is covered', () => {
    const toolbar = { x: 0, y: 0, width: 156, height: 34 }
    expect(arrange([name(10, 2)], size, [toolbar])).toEqual([null])
    expect(arrange([name(10, 31)], size, [toolbar])).toEqual([{ left: 16, top: 35 }])
  })
})
