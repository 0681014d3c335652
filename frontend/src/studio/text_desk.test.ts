import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import type { Command } from '../wire/commands'
import type { DocumentState } from '../wire/messages'
import { EDITS } from './edit_table'
import { DELAY } from './outbox'
import { createStudioStore, type StudioStore } from './state'
import { TextDesk } from './text_desk'

const document = (name: string): DocumentState => ({
  name,
  uri: `file:///cell/${name}`,
  language: 'task',
  text: 'mov a',
  version: 0,
  unsaved: false,
  conflict: false,
  recovered: false,
  base: '',
})
const MAIN = 'programs/main.task'

let store: StudioStore
let sent: Command[]
let warned: string[]
let connected: boolean
let desk: TextDesk

beforeEach(() => {
  vi.useFakeTimers()
  store = createStudioStore()
  store.setState({ editing: true })
  sent = []
  warned = []
  connected = true
  const send = (command: Command) => {
    if (connected) sent.push(command)
    return connected
  }
  desk = new TextDesk(store, send, text => warned.push(text))
  desk.documents.welcome([document(MAIN), document('cell.toml')])
  desk.sync()
})
afterEach(() => {
  vi.useRealTimers()
})

test('keystrokes close together are sent as one, the newest text', () => {
  desk.edit(MAIN, 'mov b')
  desk.edit(MAIN, 'mov bc')
  expect(sent).toEqual([])
  vi.advanceTimersByTime(DELAY)
  expect(sent).toEqual([{ type: 'edit', document: MAIN, text: 'mov bc', version: 2, base: '' }])
  vi.advanceTimersByTime(10 * DELAY)
  expect(sent).toHaveLength(1)
  expect(desk.delivered).toBe(false)
})

test('what was typed is on the line before it is saved', () => {
  desk.edit(MAIN, 'mov b')
  desk.save(MAIN, 'keep')
  expect(sent.map(one => one.type)).toEqual(['edit', 'save'])
})

test('without a connection text is kept for later, and saving says so', () => {
  connected = false
  desk.edit(MAIN, 'mov b')
  desk.save(MAIN, 'keep')
  expect(warned).toHaveLength(1)
  connected = true
  desk.flush()
  expect(sent).toEqual([{ type: 'edit', document: MAIN, text: 'mov b', version: 1, base: '' }])
})

test('a tab without the right to edit sends nothing until it has it', () => {
  store.setState({ editing: false })
  desk.edit(MAIN, 'mov b')
  vi.advanceTimersByTime(DELAY)
  desk.flush()
  expect(sent).toEqual([])
  store.setState({ editing: true })
  desk.flush()
  expect(sent).toHaveLength(1)
})

test('a document that is gone gives way to the first one', () => {
  store.setState({ document: MAIN })
  desk.documents.welcome([document('cell.toml')])
  desk.sync()
  expect(store.getState().document).toBe('cell.toml')
})

test('only places in known documents are gone to', () => {
  const places: string[] = []
  const stop = desk.onGoTo(place => places.push(place.document))
  desk.goTo({ document: 'nowhere.task', line: 1, column: 1 })
  desk.goTo({ document: MAIN, line: 1, column: 1 })
  stop()
  desk.goTo({ document: 'cell.toml', line: 1, column: 1 })
  expect(places).toEqual([MAIN])
  expect(store.getState().document).toBe('cell.toml')
})

test('what the Edit menu asks for waits for an editor, once', () => {
  const [find, replace] = EDITS.find
  if (!find || !replace) throw new Error('there are two')
  const done: string[] = []
  expect(desk.act(find)).toBe(false)
  const stop = desk.onAct(entry => done.push(entry.action))
  expect(desk.act(replace)).toBe(true)
  stop()
  desk.onAct(entry => done.push(entry.action))
  expect(done).toEqual(['find', 'replace'])
})

test('names of points in tables are taken when a point is taught', () => {
  const names: ReadonlySet<string>[] = []
  desk.onTeach((_, taken) => {
    names.push(taken)
    return null
  })
  desk.setPoints(['P1', 'rack 2'])
  desk.teach('(1)')
  expect([...(names[0] ?? [])]).toEqual(expect.arrayContaining(['mov', 'a', 'p1', 'rack']))
})
