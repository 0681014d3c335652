import { describe, expect, it } from 'vitest'
import { scrolledTo } from './panel_room'

const SEEN = { top: 100, height: 200 }

describe('a panel takes room', () => {
  it('leaves the text where the line still is in sight', () => {
    expect(scrolledTo({ top: 120, bottom: 140 }, SEEN, 150)).toBe(100)
  })
  it('moves the text as far as the line needs', () => {
    const top = scrolledTo({ top: 270, bottom: 290 }, SEEN, 150)
    expect(top).toBeGreaterThanOrEqual(290 - 150)
    expect(top).toBeLessThan(290 - 150 + 20)
  })
  it('leaves alone a text whose line was out of sight, and one that gains room', () => {
    expect(scrolledTo({ top: 500, bottom: 520 }, SEEN, 150)).toBe(100)
    expect(scrolledTo({ top: 270, bottom: 290 }, SEEN, 250)).toBe(100)
  })
  it('never hides the begin of a line that is higher than what is seen', () => {
    expect(scrolledTo({ top: 110, bottom: 290 }, SEEN, 100)).toBe(110)
  })
})
