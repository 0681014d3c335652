import { expect, test } from 'vitest'
import { inRange } from './range'

const SAID = 'no'
const JOINT = { lower: -1.7453, upper: 1.7453, said: SAID }
const STEP = { lower: 1e-4, upper: 1, said: SAID }

test('an end may be typed rounded, and no more', () => {
  expect(inRange({ value: 1.74537 }, JOINT)).toEqual({ value: 1.7453 })
  expect(inRange({ value: 1.746 }, JOINT)).toEqual({ mistake: SAID })
  expect(inRange({ value: -1.746 }, JOINT)).toEqual({ mistake: SAID })
})

test('the least step is taken as it is, and none below it', () => {
  expect(inRange({ value: 1e-4 }, STEP)).toEqual({ value: 1e-4 })
  for (const value of [0, -0.005, 5e-5]) expect(inRange({ value }, STEP)).toEqual({ mistake: SAID })
})

test('without a range everything is taken, and a mistake stays one', () => {
  expect(inRange({ value: 1e9 }, undefined)).toEqual({ value: 1e9 })
  expect(inRange({ mistake: 'x' }, STEP)).toEqual({ mistake: 'x' })
})
