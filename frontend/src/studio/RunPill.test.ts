import { expect, test } from 'vitest'
import { words } from '../text/messages'
import { runWords } from './RunPill'
import type { StudioState } from './state'

const simulated = {
  connection: 'connected',
  live: null,
  status: { state: 'done' },
  problems: [],
} as unknown as StudioState

test('a live run that is computed at half the speed of the clock says so', () => {
  const live = { type: 'live', state: 'running', speed: 1, program: 'main', override: 1 } as const
  const state = { ...simulated, live } as unknown as StudioState
  expect(runWords({ ...state, pace: 1 })).toEqual(['running', 'Live 1×'])
  expect(runWords({ ...state, pace: null })).toEqual(['running', 'Live 1×'])
  expect(runWords({ ...state, pace: 0.5 })).toEqual(['warning', 'Live, 0.5 × real time: computed too slowly'])
  const quick = { ...state, live: { ...live, speed: 4 }, pace: 2 }
  expect(runWords(quick)).toEqual(['warning', 'Live, 2 × real time instead of 4 ×: computed too slowly'])
})

test('a run that is done but not here yet is not told as a good one', () => {
  expect(runWords({ ...simulated, shown: 0 })).toEqual(['quiet', words.run.preparing])
  expect(runWords({ ...simulated, shown: 1 })).toEqual(['good', words.run.done])
})
