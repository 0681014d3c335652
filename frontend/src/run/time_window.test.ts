import { beforeEach, describe, expect, it } from 'vitest'
import { SHORTEST, TimeWindow } from './time_window'

let shown: TimeWindow
beforeEach(() => {
  shown = new TimeWindow()
  shown.setEnd(100)
})

describe('the shown stretch of time', () => {
  it('is the whole run until somebody zooms', () => {
    expect([shown.from, shown.to, shown.zoomed]).toEqual([0, 100, false])
    shown.setEnd(150)
    expect([shown.from, shown.to]).toEqual([0, 150])
  })

  it('keeps the time under the pointer where it is', () => {
    const before = shown.x(30, 800)
    shown.zoom(4, 30)
    expect(shown.to - shown.from).toBeCloseTo(25)
    expect(shown.x(30, 800)).toBeCloseTo(before)
  })

  it('never leaves the run and never becomes a point', () => {
    shown.zoom(4, 0)
    expect(shown.from).toBe(0)
    shown.pan(-10)
    expect(shown.from).toBe(0)
    shown.pan(1000)
    expect(shown.to).toBe(100)
    shown.zoom(1e9, 50)
    expect(shown.to - shown.from).toBeCloseTo(SHORTEST)
    shown.zoom(1e-9, 50)
    expect([shown.from, shown.to]).toEqual([0, 100])
  })

  it('reads back the time of a place', () => {
    shown.zoom(3, 70)
    expect(shown.time(shown.x(71, 640), 640)).toBeCloseTo(71)
    expect(shown.time(-1e6, 640)).toBe(0)
    expect(shown.time(1e6, 640)).toBe(100)
  })

  it('moves on with a cursor that leaves it, either way', () => {
    shown.zoom(10, 0)
    expect(shown.follow(5)).toBe(false)
    expect(shown.follow(11)).toBe(true)
    expect(shown.from).toBeCloseTo(10)
    expect(shown.follow(2)).toBe(true)
    expect(shown.from).toBe(0)
  })

  it('stays within a run that has become shorter', () => {
    shown.zoom(10, 95)
    shown.setEnd(92)
    expect(shown.to).toBeCloseTo(92)
    expect(shown.to - shown.from).toBeCloseTo(10)
    shown.setEnd(3)
    expect([shown.from, shown.to]).toEqual([0, 3])
  })

  it('stays where it was chosen while results of other lengths come', () => {
    shown.zoom(10, 60)
    const chosen = [shown.from, shown.to]
    for (const end of [120, 30, 5, 0, 61, 100]) {
      shown.setEnd(end)
      expect(shown.to).toBeLessThanOrEqual(end)
      expect(shown.follow(Math.min(60, end))).toBe(false)
    }
    expect([shown.from, shown.to]).toEqual(chosen)
  })

  it('is the whole of each result once the user has gone back to that', () => {
    shown.zoom(10, 60)
    shown.setEnd(3)
    shown.fit()
    shown.setEnd(100)
    expect([shown.from, shown.to]).toEqual([0, 100])
  })
})
