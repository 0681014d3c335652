import { expect, test } from 'vitest'
import { keepable } from './pasted'

test('what files keep is pasted as it is', () => {
  for (const text of ['', 'mov home\n', 'größer – 😀😀', '\ud83d\ude00']) expect(keepable(text)).toBe(text)
})

test('half a character becomes the sign for one, and byte order marks go', () => {
  expect(keepable('# a\ud800b')).toBe('# a\ufffdb')
  expect(keepable('\udc00\ud83d\ude00\ud83d')).toBe('\ufffd😀\ufffd')
  expect(keepable('\ufeffmov home\n\ufeff')).toBe('mov home\n')
})

test('what is pasted can be written as UTF-8 and read again', () => {
  const round = (text: string) => new TextDecoder().decode(new TextEncoder().encode(text))
  for (const text of ['\ud800', 'x\udfff', '\udc00\ud800', 'a\ud83d\ude00\ude00']) {
    const kept = keepable(text)
    expect(round(kept)).toBe(kept)
  }
})
