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

test('a run that is done but not here yet is not told as a good one', () => {
  expect(runWords({ ...simulated, shown: 0 })).toEqual(['quiet', words.run.preparing])
  expect(runWords({ ...simulated, shown: 1 })).toEqual(['good', words.run.done])
})
