import { foldKeymap } from '@codemirror/language'
import { expect, test } from 'vitest'
import { LANGUAGE_KEYS } from '../editor/language_keys'
import { EDITOR_KEYS } from './editor_keys'

const named = (key: string | undefined) => (key ?? '').replace('Mod-', 'Ctrl-').replaceAll('-', '+')

const listed = EDITOR_KEYS.flatMap(([keys]) => keys)
const asking = LANGUAGE_KEYS.map(one => named(one.key))
const folding = foldKeymap.map(one => named(one.key))

test('every key of the sheet acts in the editor', () => {
  expect(listed.filter(key => !asking.includes(key) && !folding.includes(key))).toEqual([])
})

test('every key that asks the language server is on the sheet', () => {
  expect(asking.filter(key => key !== 'Escape' && !listed.includes(key))).toEqual([])
})
