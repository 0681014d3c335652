import { describe, expect, it } from 'vitest'
import { FINISHES, finishBytes, longestAxis } from './finish'

const plank = [0, 0, 0, 0.1, 0.8, 0.02, 0.1, 0, 0.02]

describe('finish', () => {
  it('lets fibres of wood run along the longest side', () => {
    expect(longestAxis(plank)).toBe(1)
    expect(finishBytes('wood', plank)[2]).toBe(170)
  })

  it('gives no other material a grain', () => {
    for (const material of ['paint', 'steel', 'cardboard', 'rubber', 'glass'] as const) {
      expect(finishBytes(material, plank)[2]).toBe(0)
    }
  })

  it('tells every material from every other one', () => {
    const looks = Object.values(FINISHES).map(one => JSON.stringify(one))
    expect(new Set(looks).size).toBe(looks.length)
  })
})
