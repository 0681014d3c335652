import { foldKeymap } from '@codemirror/language'
import { searchKeymap } from '@codemirror/search'
import { expect, test } from 'vitest'
import { EDIT_KEYS } from '../editor/edit_actions'
import { EDIT_ENTRIES } from '../studio/edit_table'
import { KEPT_BY_BROWSER } from '../studio/keys'
import { EDITOR_KEYS } from './editor_keys'

const named = (key: string | undefined) => (key ?? '').replace('Mod-', 'Ctrl-').replaceAll('-', '+')

const listed = EDITOR_KEYS.flatMap(([keys]) => keys)
const folding = foldKeymap.map(one => named(one.key))
const finding = searchKeymap.flatMap(one => [named(one.key), `Shift+${named(one.key)}`])

test('every key of the sheet acts in the editor', () => {
  expect(listed.filter(key => !finding.includes(key) && !folding.includes(key))).toEqual([])
})

test('every key of the table acts in the editor, and none is kept by the browser', () => {
  const keys = EDIT_ENTRIES.flatMap(one => one.keys)
  const acting = EDIT_KEYS.map(one => named(one.key).toUpperCase())
  expect(keys.filter(key => !acting.includes(key.toUpperCase()))).toEqual([])
  expect(keys.filter(key => KEPT_BY_BROWSER.includes(key))).toEqual([])
})
