import { describe, expect, test } from 'vitest'
import { lineMap } from './line_map'

const TEXT = 'program p\nmov a\nmov b\ngrip\nmov a'

/** Where lines 1, 2, … of the older text are in the newer one. */
function moved(newer: string, older = TEXT): readonly (number | null)[] {
  const map = lineMap(older, newer)
  return older.split('\n').map((_, at) => map.toNew(at + 1))
}

describe('lines of a text that was edited', () => {
  test.each([
    ['nothing', TEXT, [1, 2, 3, 4, 5]],
    ['a line on top', `# new\n${TEXT}`, [2, 3, 4, 5, 6]],
    ['a blank line inside', TEXT.replace('grip', '\ngrip'), [1, 2, 3, 5, 6]],
    ['lines in two places', `# top\n${TEXT.replace('grip', '# here\ngrip')}`, [2, 3, 4, 6, 7]],
    ['a line gone', TEXT.replace('mov b\n', ''), [1, 2, null, 3, 4]],
    ['a line edited', TEXT.replace('mov b', 'lin b'), [1, 2, 3, 4, 5]],
    ['a line edited below a new one', `# new\n${TEXT.replace('mov b', 'lin b')}`, [2, 3, 4, 5, 6]],
    ['blanks at the ends of lines', TEXT.replace(/\n/g, '  \r\n  '), [1, 2, 3, 4, 5]],
    ['all of it', '', [null, null, null, null, null]],
  ] as const)('%s', (_, newer, places) => {
    expect(moved(newer)).toEqual(places)
  })

  test('the way back is the same way', () => {
    const newer = `# top\n${TEXT.replace('grip', '# here\ngrip')}`
    const map = lineMap(TEXT, newer)
    for (const line of [1, 2, 3, 4, 5]) expect(map.toOld(map.toNew(line) ?? 0)).toBe(line)
    expect(map.toOld(1)).toBeNull()
    expect(map.toOld(5)).toBeNull()
  })

  test('places outside of the texts are nowhere', () => {
    const map = lineMap(TEXT, `${TEXT}\n`)
    expect([map.toNew(0), map.toNew(6), map.toOld(99)]).toEqual([null, null, null])
  })
})
