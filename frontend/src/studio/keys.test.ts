import { expect, test } from 'vitest'
import { actsWhileTyping, isTyping, keyName, takesPlainKey } from './keys'

const press = (key: string, held: Partial<KeyboardEvent> = {}) => ({ key, ...held }) as KeyboardEvent
const target = (values: object) => values as unknown as EventTarget

test('keys are named as people read them', () => {
  expect(keyName(press('s', { ctrlKey: true }))).toBe('Ctrl+S')
  expect(keyName(press('Z', { ctrlKey: true, shiftKey: true }))).toBe('Ctrl+Shift+Z')
  expect(keyName(press(' '))).toBe('Space')
  expect(keyName(press('F8', { shiftKey: true }))).toBe('Shift+F8')
  expect(keyName(press('w', { ctrlKey: true, altKey: true }))).toBe('Ctrl+Alt+W')
})

test('the command key of a Mac stands for Ctrl', () => {
  expect(keyName(press('k', { metaKey: true }))).toBe('Ctrl+K')
})

test('a sign that needs Shift is named by itself', () => {
  expect(keyName(press('?', { shiftKey: true }))).toBe('?')
})

test('modifiers alone and dead keys have no name', () => {
  expect(['Control', 'Shift', 'Alt', 'Meta', 'Dead'].map(key => keyName(press(key)))).toEqual(
    Array(5).fill(''),
  )
})

test('text fields take text, boxes and sliders do not', () => {
  expect(isTyping(target({ tagName: 'INPUT', type: 'search' }))).toBe(true)
  expect(isTyping(target({ tagName: 'TEXTAREA' }))).toBe(true)
  expect(isTyping(target({ tagName: 'DIV', isContentEditable: true }))).toBe(true)
  expect(isTyping(target({ tagName: 'INPUT', type: 'checkbox' }))).toBe(false)
  expect(isTyping(target({ tagName: 'INPUT', type: 'range' }))).toBe(false)
  expect(isTyping(null)).toBe(false)
})

test('while typing only keys act that make no text', () => {
  expect(['Ctrl+S', 'Alt+X', 'F8', 'Shift+F8'].every(actsWhileTyping)).toBe(true)
  expect(['Space', 'ArrowLeft', 'Shift+A', 'F', 'Home'].some(actsWhileTyping)).toBe(false)
})

test('brackets that need AltGr are brackets', () => {
  const altGr = { ctrlKey: true, altKey: true, getModifierState: (key: string) => key === 'AltGraph' }
  expect(keyName(press('[', altGr as Partial<KeyboardEvent>))).toBe('[')
})

test('buttons keep Space and arrows for themselves, but not the brackets', () => {
  const closest = (selector: string) => (/(^|, )button/.test(selector) ? {} : null)
  const button = target({ tagName: 'BUTTON', closest })
  expect(takesPlainKey(button, 'Space')).toBe(true)
  expect(['[', ']', ',', '.'].some(key => takesPlainKey(button, key))).toBe(false)
  expect(takesPlainKey(target({ tagName: 'INPUT', type: 'text' }), '[')).toBe(true)
})
