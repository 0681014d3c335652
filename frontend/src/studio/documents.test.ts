import { expect, test } from 'vitest'
import type { DocumentState } from '../wire/messages'
import { Documents } from './documents'

const STATE: DocumentState = {
  name: 'programs/main.task',
  uri: 'file:///p/programs/main.task',
  language: 'task',
  text: 'one',
  version: 0,
  unsaved: false,
  conflict: false,
  recovered: false,
  base: 'b1',
}
const { text: _, ...MARKS } = STATE

function open(): Documents {
  const documents = new Documents()
  documents.welcome([STATE])
  return documents
}

test('typed text is pending until the server confirms its version', () => {
  const documents = open()
  documents.edit(STATE.name, 'two')
  documents.edit(STATE.name, 'three')
  expect(documents.pending()).toEqual([
    { type: 'edit', document: STATE.name, text: 'three', version: 2, base: 'b1' },
  ])
  documents.update([{ ...MARKS, text: null, version: 1, unsaved: true }])
  expect(documents.pending()).toHaveLength(1)
  documents.update([{ ...MARKS, text: null, version: 2, unsaved: true }])
  expect(documents.pending()).toHaveLength(0)
  expect(documents.text(STATE.name)).toBe('three')
})

test('text of a form goes to the server as what is typed does, and an editor takes it over', () => {
  const documents = open()
  documents.edit(STATE.name, 'two')
  const revision = documents.shown[0]?.revision ?? 0
  documents.write(STATE.name, 'three')
  expect(documents.shown[0]?.revision).toBe(revision + 1)
  expect(documents.pending()).toEqual([
    { type: 'edit', document: STATE.name, text: 'three', version: 2, base: 'b1' },
  ])
  documents.write(STATE.name, 'three')
  documents.write('kb/none.pl', 'x')
  expect(documents.shown).toHaveLength(1)
  expect(documents.shown[0]?.revision).toBe(revision + 1)
})

test('an edit goes out once on a connection', () => {
  const documents = open()
  documents.edit(STATE.name, 'two')
  const [edit] = documents.unsent()
  documents.sent(STATE.name, edit?.version ?? 0)
  expect(documents.unsent()).toHaveLength(0)
  expect(documents.pending()).toHaveLength(1)
})

test('text that a restarted server lacks is kept and sent again', () => {
  const documents = open()
  documents.edit(STATE.name, 'two')
  documents.sent(STATE.name, 1)
  documents.update([{ ...MARKS, text: null, version: 1, unsaved: true }])
  documents.welcome([STATE])
  expect(documents.text(STATE.name)).toBe('two')
  expect(documents.unsent()).toHaveLength(1)
  expect(documents.shown[0]?.unsaved).toBe(true)
})

test('a server that recovered the newest text gets nothing again', () => {
  const documents = open()
  documents.edit(STATE.name, 'two')
  documents.welcome([{ ...STATE, text: 'two', unsaved: true, recovered: true }])
  expect(documents.pending()).toHaveLength(0)
})

test('after saving, the file of the server counts again', () => {
  const documents = open()
  documents.edit(STATE.name, 'two')
  documents.update([{ ...MARKS, text: null, version: 1, unsaved: false }])
  documents.welcome([{ ...STATE, text: 'from the disk' }])
  expect(documents.text(STATE.name)).toBe('from the disk')
})

test('text from outside counts as a revision, own text does not', () => {
  const documents = open()
  documents.edit(STATE.name, 'two')
  expect(documents.shown[0]?.revision).toBe(0)
  documents.update([{ ...MARKS, text: 'one', version: 1 }])
  expect(documents.shown[0]?.revision).toBe(1)
  expect(documents.text(STATE.name)).toBe('one')
})

test('what the server says of an older text does not overwrite what is being typed', () => {
  const documents = open()
  documents.edit(STATE.name, 'two')
  documents.update([{ ...MARKS, text: 'older', version: 0, unsaved: true }])
  expect(documents.text(STATE.name)).toBe('two')
})

test('an edit names the content of the file on which it was written', () => {
  const documents = open()
  documents.edit(STATE.name, 'two')
  documents.update([{ ...MARKS, text: 'from elsewhere', version: 0, base: 'b2' }])
  expect(documents.pending()[0]).toMatchObject({ text: 'two', base: 'b1' })
  documents.update([{ ...MARKS, text: null, version: 1, unsaved: true, conflict: true, base: 'b1' }])
  documents.edit(STATE.name, 'three')
  documents.update([{ ...MARKS, text: null, version: 1, base: 'b3' }]) // version 1 was saved
  expect(documents.pending()[0]).toMatchObject({ text: 'three', base: 'b3' })
})

test('the list is the same until a mark changes', () => {
  const documents = open()
  const before = documents.shown
  documents.update([{ ...MARKS, text: null }])
  expect(documents.shown).toBe(before)
  documents.edit(STATE.name, 'two')
  const unsaved = documents.shown
  documents.edit(STATE.name, 'three')
  expect(unsaved).not.toBe(before)
  expect(documents.shown).toBe(unsaved)
})
