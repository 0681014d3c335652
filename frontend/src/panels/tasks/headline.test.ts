import { expect, test } from 'vitest'
import type { StepState } from '../../wire/messages'
import { headline } from './headline'

function said(accepted: boolean): StepState {
  const world = { gripper: 'open', held: '', parts: [], others: [] }
  return { call: 'c', accepted, message: '', hint: '', warning: '', told: [], world, points: [] }
}

const texts = (states: readonly (StepState | 'unfilled' | null)[]) => headline(states).map(one => one.text)

test('steps of which nothing has been said are being checked, and never accepted', () => {
  expect(texts([null])).toEqual(['1 step is being checked'])
  expect(texts([said(true), null, null])).toEqual(['2 steps are being checked'])
  expect(texts([said(false), null])).toEqual(['1 step is refused', '1 step is being checked'])
})

test('a step that nobody has filled in yet is neither refused nor accepted', () => {
  expect(headline(['unfilled'])).toEqual([{ tone: 'quiet', text: '1 step is not filled in yet' }])
  expect(texts(['unfilled', said(true), said(false)])).toEqual([
    '1 step is refused',
    '1 step is not filled in yet',
  ])
})

test('all are accepted only when each one is', () => {
  expect(texts([said(true), said(true)])).toEqual(['2 steps, all accepted'])
  expect(texts([said(true), said(false)])).toEqual(['1 step is refused'])
})
