import { completionKeymap } from '@codemirror/autocomplete'
import { defaultKeymap } from '@codemirror/commands'
import { searchKeymap } from '@codemirror/search'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { addCommands } from '../studio/builtin_commands'
import { Studio } from '../studio/studio'
import { EDIT_KEYS } from './edit_actions'
import { editorKeys, namesOf } from './editor_keymap'

let studio: Studio
beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', () => 1)
  // A browser that cannot draw.
  vi.stubGlobal('document', { createElement: () => ({ getContext: () => null }) })
  studio = new Studio('ws://127.0.0.1:9/ws/studio')
  addCommands(studio, () => {})
})

afterEach(() => {
  vi.unstubAllGlobals()
})

const names = (bindings: Parameters<typeof namesOf>[0][]) => bindings.flatMap(namesOf)

test('no key of a command that acts while text is typed is also a key of the editor, on any system', () => {
  const taken = studio.commands.keysOverText
  expect([...taken]).toEqual(expect.arrayContaining(['Ctrl+Enter', 'Ctrl+S', 'Ctrl+K', 'F1']))
  expect(names([...editorKeys(taken), ...completionKeymap]).filter(name => taken.has(name))).toEqual([])
})

test('the library has such keys: they are left out, and nothing else', () => {
  const taken = studio.commands.keysOverText
  const all = names([...editorKeys(new Set())])
  const left = names([...editorKeys(taken)])
  const out = [...new Set(all.filter(name => !left.includes(name)))].sort()
  expect(out).toEqual(['Ctrl+/', 'Ctrl+Enter', 'Ctrl+F', 'Ctrl+G', 'Ctrl+H', 'Ctrl+K', 'Ctrl+O'])
  expect(left).toEqual(
    expect.arrayContaining(['Enter', 'Shift+Enter', 'F3', 'Shift+F3', 'Ctrl+Shift+G', 'Tab']),
  )
})

test('keys of the Edit menu act in the editor, undo and redo on every system', () => {
  const edits = studio.commands.all.filter(one => one.menu === 'Edit').flatMap(one => one.keys)
  const acting = names([...editorKeys(studio.commands.keysOverText), ...EDIT_KEYS])
  expect(edits.filter(key => !acting.includes(key))).toEqual([])
  const everywhere = editorKeys(studio.commands.keysOverText).filter(
    one => !one.mac && !one.linux && !one.win,
  )
  expect(names(everywhere)).toEqual(expect.arrayContaining(['Ctrl+Z', 'Ctrl+Y', 'Ctrl+Shift+Z']))
})

test('keys of the library are named as the studio names them', () => {
  const named = (key: string) => namesOf({ key })
  expect(named('Mod-Alt-\\')).toEqual(['Ctrl+Alt+\\'])
  expect(named('Shift-Mod-k')).toEqual(['Ctrl+Shift+K'])
  expect(named('Alt-A')).toEqual(['Alt+Shift+A'])
  expect(named('Mod--')).toEqual(['Ctrl+-'])
  expect(namesOf({ key: 'Alt-ArrowLeft', mac: 'Cmd-ArrowLeft' })).toEqual(['Alt+ArrowLeft', 'Ctrl+ArrowLeft'])
  expect(names([...defaultKeymap, ...searchKeymap]).filter(name => name.endsWith('+'))).toEqual([])
})
