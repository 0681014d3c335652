import { describe, expect, it } from 'vitest'
import { movesAmong, nextEnd, pathWindow, RECENT } from './path_window'

const station = 'left'
const moves = movesAmong(
  [
    { kind: 'move', time: 2, duration: 1, station },
    { kind: 'task', time: 0, duration: 9, station },
    { kind: 'move', time: 0, duration: 1, station },
    { kind: 'move', time: 0.5, duration: 4, station: 'right' },
    { kind: 'grip', time: 1, duration: 0.2, station },
    { kind: 'move', time: 3, duration: 0, station },
    { kind: 'move', time: 4, duration: 1.5, station },
  ],
  station,
)

describe('the window of the path', () => {
  it('holds the last seconds and ends with the next move', () => {
    expect(pathWindow('recent', 2.5, moves)).toEqual({ from: 2.5 - RECENT, until: 2.5, to: 5.5 })
    expect(pathWindow('recent', 1.5, moves)).toEqual({ from: 1.5 - RECENT, until: 1.5, to: 3 })
  })

  it('begins with the first move and ends with the last', () => {
    expect(nextEnd(moves, 0)).toBe(1)
    expect(nextEnd(moves, 4.2)).toBe(5.5)
    expect(nextEnd(moves, 9)).toBe(9)
  })

  it('has no future where none is known', () => {
    expect(pathWindow('recent', 7, [])).toEqual({ from: 4, until: 7, to: 7 })
  })

  it('is open where all is to be seen', () => {
    expect(pathWindow('all', 7, moves)).toEqual({
      from: Number.NEGATIVE_INFINITY,
      until: 7,
      to: Number.POSITIVE_INFINITY,
    })
  })

  it('leaves out what moves nothing', () => {
    expect(moves.map(({ time }) => time)).toEqual([0, 2, 4])
  })
})
