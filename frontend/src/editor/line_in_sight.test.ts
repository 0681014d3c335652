import { describe, expect, it } from 'vitest'
import { LineInSight, PATIENCE } from './line_in_sight'

const LINE = 20

function text(top: number, height = 200) {
  const scrolled: [number, number][] = []
  let now = 0
  const sight = new LineInSight(
    {
      block: line => ({ top: LINE * (line - 1), bottom: LINE * line }),
      seen: () => ({ top, bottom: top + height }),
      scroll: (line, margin) => scrolled.push([line, margin]),
    },
    () => now,
  )
  return { sight, scrolled, wait: (milliseconds: number) => (now += milliseconds) }
}

describe('a line that is kept in sight', () => {
  it('is scrolled to when it is above or below, not when it is seen', () => {
    const { sight, scrolled } = text(100)
    for (const line of [6, 15]) sight.show(line)
    expect(scrolled).toEqual([])
    for (const line of [5, 16]) sight.show(line)
    expect(scrolled.map(([line]) => line)).toEqual([5, 16])
  })

  it('leaves the text alone until the user has been quiet for a while', () => {
    const { sight, scrolled, wait } = text(0)
    sight.touch()
    wait(PATIENCE - 1)
    sight.show(50)
    expect(scrolled).toEqual([])
    wait(1)
    sight.show(50)
    expect(scrolled).toHaveLength(1)
  })

  it('asks for no more room than there is', () => {
    const { sight, scrolled } = text(0, 60)
    sight.show(50)
    expect(scrolled).toEqual([[50, 20]])
  })
})
