import { expect, test } from 'vitest'
import { answerTo, enter } from './entry'

test('the answer is the one that the server works out', async () => {
  // python: hmac.digest(b's3cret', b'n 8123', 'sha256').hex()
  expect(await answerTo('n', 's3cret', '8123')).toBe(
    '840b130430fcda865cecb91f0075dba20e9123cf5df95d52f44012a755b4d02a',
  )
  expect(await answerTo('n', '', '8123')).toBe('')
})

test('other messages do not belong to entering', () => {
  const socket = { readyState: 1, send: () => {} } as unknown as WebSocket
  const given: string[] = []
  const door = { answer: async () => '', entered: (...all: string[]) => given.push(...all) }
  expect(enter(socket, { type: 'welcome' }, door)).toBe('none')
  expect(enter(socket, { type: 'entered', ticket: 't', key: 'k' }, door)).toBe('in')
  expect(given).toEqual(['t', 'k'])
})
