import { expect, test } from 'vitest'
import { DELAY, type HeldMove, Hold, PERIOD } from './hold'

/** A clock that a test turns, and the amounts that were moved. */
function holding(change: Partial<HeldMove> = {}) {
  let now = 0
  let act: (() => void) | null = null
  const moved: number[] = []
  let ends = 0
  const hold = new Hold({
    now: () => now,
    every: (_, tick) => {
      act = tick
      return () => {
        act = null
      }
    },
  })
  const move: HeldMove = {
    step: 0.01,
    fastest: 0.25,
    move: amount => moved.push(amount) > 0,
    busy: () => false,
    end: () => {
      ends += 1
    },
    ...change,
  }
  const wait = (milliseconds: number) => {
    for (const end = now + milliseconds; now < end; ) {
      now += PERIOD
      act?.()
    }
  }
  return { hold, move, moved, wait, ends: () => ends, sleep: (by: number) => (now += by) }
}

test('a short press is one step', () => {
  const { hold, move, moved, wait, ends } = holding()
  hold.press(move)
  wait(DELAY - PERIOD)
  hold.release()
  wait(1000)
  expect(moved).toEqual([0.01])
  expect(ends()).toBe(1)
})

test('held, it goes on ever faster and never above its limit', () => {
  const { hold, move, moved, wait } = holding()
  hold.press(move)
  wait(DELAY + 5000)
  const rates = moved.slice(1).map(amount => amount / (PERIOD / 1000))
  expect(rates.length).toBeGreaterThan(50)
  expect(rates.every((one, at) => at === 0 || one >= (rates[at - 1] ?? 0) - 1e-9)).toBe(true)
  expect(Math.max(...rates)).toBeLessThanOrEqual(move.fastest + 1e-9)
  expect(rates.at(-1)).toBeCloseTo(move.fastest)
})

test('let go, it stands still', () => {
  const { hold, move, moved, wait } = holding()
  hold.press(move)
  wait(1000)
  hold.release()
  const before = moved.length
  wait(1000)
  expect(moved).toHaveLength(before)
  expect(hold.held).toBe(false)
})

test('where it goes no further it ends by itself, once', () => {
  let left = 5
  const { hold, move, wait, ends } = holding({ move: () => --left > 0 })
  hold.press(move)
  wait(2000)
  expect(left).toBe(0)
  expect(ends()).toBe(1)
})

test('it waits for the answer to the last movement, and a page that slept does not leap', () => {
  let isBusy = false
  const { hold, move, moved, wait, sleep } = holding({ busy: () => isBusy })
  hold.press(move)
  wait(DELAY + PERIOD)
  isBusy = true
  const before = moved.length
  wait(500)
  expect(moved).toHaveLength(before)
  isBusy = false
  sleep(60_000)
  wait(PERIOD)
  expect(moved.at(-1)).toBeLessThanOrEqual(0.15 * move.fastest + 1e-9)
})
