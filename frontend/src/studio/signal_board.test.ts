import { beforeEach, expect, test } from 'vitest'
import type { SignalDescription } from '../scene/description'
import type { Command } from '../wire/commands'
import type { LiveStatus } from '../wire/messages'
import { SignalBoard } from './signal_board'
import { createStudioStore, type StudioStore } from './state'
import { ProjectStorage } from './storage'
import { UndoStack } from './undo'

const input = (name: string, extra: Partial<SignalDescription> = {}): SignalDescription => ({
  name,
  input: true,
  analog: false,
  initial: 0,
  ...extra,
})
const SIGNALS = [
  input('start'),
  input('door', { initial: 1 }),
  input('pressure', { analog: true }),
  input('lamp', { input: false }),
]
const RUNNING: LiveStatus = { type: 'live', state: 'running', speed: 1, program: 'main', override: 1 }

/** What a browser would keep. */
class Kept extends ProjectStorage {
  readonly values = new Map<string, unknown>()

  override read(name: string): unknown {
    return this.values.get(name) ?? null
  }

  override write(name: string, value: unknown): void {
    this.values.set(name, JSON.parse(JSON.stringify(value)))
  }
}

let store: StudioStore
let undo: UndoStack
let kept: Kept
let sent: Command[]
let board: SignalBoard

function newBoard(): SignalBoard {
  const made = new SignalBoard(command => sent.push(command) > 0, store, undo)
  made.setSignals(SIGNALS, kept)
  return made
}

beforeEach(() => {
  store = createStudioStore()
  undo = new UndoStack()
  kept = new Kept('/cell')
  sent = []
  board = newBoard()
})

function press(code: string, extra: Partial<KeyboardEvent> = {}): boolean {
  return board.key({ type: 'keydown', code, target: null, ...extra } as KeyboardEvent)
}

const codes = (of: SignalBoard) => of.bindings.map(one => one.code)

test('inputs have a digit each and a fitting way to be set; outputs have none', () => {
  expect(board.bindings.map(({ signal, code, mode, off, on }) => [signal, code, mode, off, on])).toEqual([
    ['start', 'Digit1', 'hold', 0, 1],
    ['door', 'Digit2', 'hold', 1, 0],
    ['pressure', 'Digit3', 'ramp', 0, 1],
  ])
})

test('keys reach the cell in a live run only', () => {
  board.arm()
  press('Digit1')
  expect(sent).toEqual([])
  board.blur()
  store.setState({ live: RUNNING })
  press('Digit1')
  board.key({ type: 'keyup', code: 'Digit1' } as KeyboardEvent)
  expect(sent).toEqual([
    { type: 'signal', name: 'start', value: 1 },
    { type: 'signal', name: 'start', value: 0 },
  ])
})

test('keys that are not armed, typed, repeated or held with Ctrl set nothing', () => {
  store.setState({ live: RUNNING })
  expect(press('Digit1')).toBe(false)
  board.arm()
  const field = { tagName: 'INPUT', type: 'text' } as unknown as EventTarget
  expect(press('Digit1', { target: field })).toBe(false)
  expect(press('Digit1', { ctrlKey: true })).toBe(false)
  expect(press('Digit1', { repeat: true })).toBe(true)
  expect(sent).toEqual([])
})

test('a key belongs to one signal, and changing it can be undone', () => {
  board.rebind('door', { code: 'Digit1' }, 'Key of door')
  expect(codes(board)).toEqual(['', 'Digit1', 'Digit3'])
  undo.undo()
  expect(codes(board)).toEqual(['Digit1', 'Digit2', 'Digit3'])
})

test('keys are kept with the project; what cannot be read is left out', () => {
  board.rebind('start', { code: 'Space', mode: 'toggle' }, 'Key of start')
  expect(codes(newBoard())).toEqual(['Space', 'Digit2', 'Digit3'])
  kept.values.set('key bindings', [{ signal: 'start', code: 7 }, null, 'x'])
  expect(codes(newBoard())).toEqual(['Digit1', 'Digit2', 'Digit3'])
})
