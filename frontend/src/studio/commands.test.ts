import { expect, test } from 'vitest'
import { Commands, type StudioCommand } from './commands'
import { KEPT_BY_BROWSER } from './keys'

interface Press {
  readonly key: string
  readonly ctrl?: boolean
  readonly shift?: boolean
  readonly on?: 'text' | 'button' | 'view' | 'page'
  readonly repeat?: boolean
}

function press({ key, ctrl = false, shift = false, on = 'page', repeat = false }: Press): KeyboardEvent {
  const targets = {
    text: { tagName: 'INPUT', type: 'text', closest: () => ({}) },
    button: { tagName: 'BUTTON', closest: () => ({}) },
    view: { tagName: 'DIV', closest: (wanted: string) => (wanted.includes('application') ? {} : null) },
    page: { tagName: 'BODY', closest: () => null },
  }
  const modifiers = { ctrlKey: ctrl, shiftKey: shift, altKey: false, metaKey: false }
  const event = {
    key,
    ...modifiers,
    repeat,
    defaultPrevented: false,
    isComposing: false,
    target: targets[on],
  }
  return event as unknown as KeyboardEvent
}

function bench(extra: Partial<StudioCommand> & Pick<StudioCommand, 'keys'>) {
  const commands = new Commands()
  const done: string[] = []
  const run = () => done.push('done')
  commands.add({ id: 'a.b', title: 'Do it', menu: 'File', group: 'x', run, ...extra })
  return { commands, done }
}

test('a key runs its command', () => {
  const { commands, done } = bench({ keys: ['Ctrl+S'] })
  expect(commands.key(press({ key: 's', ctrl: true }))).toBe(true)
  expect(commands.key(press({ key: 's' }))).toBe(false)
  expect(done).toHaveLength(1)
})

test('plain keys act on the page, never while typing or on a control', () => {
  const { commands, done } = bench({ keys: ['Space'] })
  expect(commands.key(press({ key: ' ', on: 'text' }))).toBe(false)
  expect(commands.key(press({ key: ' ', on: 'button' }))).toBe(false)
  expect(done).toHaveLength(0)
  expect(commands.key(press({ key: ' ' }))).toBe(true)
})

test('plain keys that a 3-D view leaves alone act there, too', () => {
  const { commands } = bench({ keys: ['Space'] })
  expect(commands.key(press({ key: ' ', on: 'view' }))).toBe(true)
})

test('keys with Ctrl and function keys act while typing, unless the text keeps them', () => {
  const { commands } = bench({ keys: ['F8'] })
  expect(commands.key(press({ key: 'F8', on: 'text' }))).toBe(true)
  const undo = bench({ keys: ['Ctrl+Z'], textKeeps: true })
  expect(undo.commands.key(press({ key: 'z', ctrl: true, on: 'text' }))).toBe(false)
  expect(undo.commands.key(press({ key: 'z', ctrl: true }))).toBe(true)
})

test('a command that cannot be done takes its key and does nothing', () => {
  const { commands, done } = bench({ keys: ['F8'], enabled: () => false })
  expect(commands.key(press({ key: 'F8' }))).toBe(true)
  expect(commands.run('a.b')).toBe(false)
  expect(done).toHaveLength(0)
})

test('a held key acts once', () => {
  const { commands, done } = bench({ keys: ['F8'] })
  commands.key(press({ key: 'F8' }))
  commands.key(press({ key: 'F8', repeat: true }))
  expect(done).toHaveLength(1)
})

test('shift counts with letters and named keys', () => {
  const { commands, done } = bench({ keys: ['Ctrl+Shift+Z', 'Shift+F8'] })
  commands.key(press({ key: 'Z', ctrl: true, shift: true }))
  commands.key(press({ key: 'F8', shift: true }))
  commands.key(press({ key: 'F8' }))
  expect(done).toHaveLength(2)
})

test('two commands cannot share a key, and none can have what the browser keeps', () => {
  const { commands } = bench({ keys: ['Ctrl+S'] })
  const other = { id: 'c', title: 'Other', menu: 'File', group: 'x', run: () => {} } as const
  expect(() => commands.add({ ...other, keys: ['Ctrl+S'] })).toThrow('belongs to a.b')
  for (const key of KEPT_BY_BROWSER) expect(() => commands.add({ ...other, keys: [key] })).toThrow(key)
})

test('a command that is taken out gives its key back', () => {
  const commands = new Commands()
  const one = { id: 'a', title: 'One', menu: 'File', group: 'x', keys: ['F8'], run: () => {} } as const
  commands.add(one)()
  expect(commands.key(press({ key: 'F8' }))).toBe(false)
  expect(() => commands.add(one)).not.toThrow()
})

test('the palette finds by any words of title and menu', () => {
  const { commands } = bench({ keys: [], title: 'Fit selection or all', menu: 'View' })
  expect(commands.search('view fit')).toHaveLength(1)
  expect(commands.search('all FIT')).toHaveLength(1)
  expect(commands.search('fit nothing')).toHaveLength(0)
})
