import { expect, test } from 'vitest'
import { DEFAULT_LOOK, lookFrom } from './look'

test('a kept look comes back, with what it does not say as usual', () => {
  expect(lookFrom({ layout: '1', hidden: ['table'] })).toEqual({
    ...DEFAULT_LOOK,
    layout: '1',
    hidden: ['table'],
  })
  expect(lookFrom(null)).toEqual(DEFAULT_LOOK)
})

test.each([
  { layout: '9' },
  { shading: 'cartoon' },
  { path: 'longest' },
  { frames: 'world' },
  { hidden: null },
  { arm: '1' },
  { opacity: null },
])('a look that is not sound (%j) is not taken', kept => {
  expect(lookFrom(kept)).toEqual(DEFAULT_LOOK)
})
