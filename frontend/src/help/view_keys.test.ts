import { expect, test } from 'vitest'
import type { Pilot } from '../scene/pilot'
import { pressKey } from '../scene/view_keys'
import { VIEW_KEYS } from './view_keys'

function acts(name: string): boolean {
  const shiftKey = name.startsWith('Shift+')
  const pilot = new Proxy({}, { get: () => () => undefined }) as unknown as Pilot
  const event = { key: name.replace('Shift+', ''), shiftKey, ctrlKey: false, metaKey: false, altKey: false }
  return pressKey(pilot, event, { fitSelection: () => undefined, fitAll: () => undefined })
}

const listed = VIEW_KEYS.flatMap(([keys]) => keys)

test('every key of the sheet acts in a view', () => {
  expect(listed.filter(key => !acts(key))).toEqual([])
})

test('every key that acts in a view is on the sheet', () => {
  const signs = Array.from({ length: 95 }, (_, at) => String.fromCharCode(32 + at))
  const named = [
    'Home',
    'End',
    'PageUp',
    'PageDown',
    'Enter',
    'Tab',
    'Insert',
    'Delete',
    'Backspace',
    'F1',
    'F6',
  ]
  const arrows = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown']
  const acting = [...signs, ...named, ...arrows]
    .filter(acts)
    .map(key => (key.length === 1 ? key.toUpperCase() : key))
  // `=` is `+` without Shift on most keyboards
  expect(new Set(acting.filter(key => key !== '='))).toEqual(
    new Set(listed.filter(key => !key.startsWith('Shift+'))),
  )
})
