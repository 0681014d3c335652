import { expect, test } from 'vitest'
import { ranInstead, runMark } from './run_mark'

const station = (name: string, program: string) => ({ name, program, source: `programs/${program}.task` })
const state = { ran: 'ops', program: 'ops', told: false, stale: false, changed: false, older: false }
const other = { ...state, program: 'main' }
const alone = [station('robot', 'ops')]

test('the run of the chosen program and of the texts as they are has no mark', () => {
  expect(runMark(state, alone)).toBe('')
  expect(runMark({ ...state, ran: '', program: 'main' }, [])).toBe('')
})

test('the run of another program is marked with its name, also before anything is known of the chosen one', () => {
  expect(runMark(other, alone)).toBe('run of ops')
  expect(runMark({ ...other, changed: true }, alone)).toBe('before the change of the text, of ops')
})

test('the last valid run of another program is said to be of that', () => {
  expect(runMark({ ...other, stale: true, changed: true }, alone)).toBe('last valid run, of ops')
  expect(runMark({ ...state, stale: true }, alone)).toBe('last valid run')
})

test('a run of several stations is that of each of their programs', () => {
  const both = [station('left', 'ops'), station('right', 'main')]
  expect(ranInstead(other, both)).toBe('')
  expect(ranInstead({ ...other, program: 'third' }, both)).toBe('ops')
})

test('what commands did is of no program', () => {
  expect(runMark({ ...other, ran: '', told: true }, alone)).toBe('')
})
