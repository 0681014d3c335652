import { expect, test } from 'vitest'
import { isBehind, Pace } from './pace'

/** A run that goes at some paces, each for some seconds, with 25 frames per second. */
function run(...legs: readonly (readonly [pace: number, seconds: number])[]): Pace {
  const pace = new Pace()
  let time = 0
  let wall = 1_700_000_000_000
  for (const [rate, seconds] of legs) {
    for (let frame = 0; frame < 25 * seconds; frame += 1) {
      pace.add(time, wall)
      time += rate / 25
      wall += 40
    }
  }
  return pace
}

test('a run that is computed at half the speed of the clock says so', () => {
  expect(run([0.5, 3]).value).toBe(0.5)
  expect(run([1, 3]).value).toBe(1)
  expect(run([4, 3]).value).toBe(4)
})

test('it is the pace of the last two seconds', () => {
  expect(run([1, 10], [0.5, 3]).value).toBe(0.5)
})

test('in the first second, and after a change of the wanted pace, nothing is known', () => {
  expect(run([0.5, 0.9]).value).toBeNull()
  const changed = run([1, 5])
  changed.reset()
  expect(changed.value).toBeNull()
})

test('another run begins anew', () => {
  const pace = run([1, 5])
  pace.add(0, 1_700_000_100_000)
  expect(pace.value).toBeNull()
})

test('a run is behind where it clearly lacks a part of the wanted pace', () => {
  expect(isBehind(0.5, 1)).toBe(true)
  expect(isBehind(1, 1)).toBe(false)
  expect(isBehind(1, 4)).toBe(true)
  expect(isBehind(null, 1)).toBe(false)
})
