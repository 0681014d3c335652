/** Signals of the cell in the page: keys that set inputs, the switch that arms them, what was pressed. */
import type { SignalDescription } from '../scene/description'
import type { Command } from '../wire/commands'
import { KEY_MODES, type KeyBinding, type KeyMode, KeySensors } from './key_sensors'
import { isTyping } from './keys'
import type { StudioStore } from './state'
import type { ProjectStorage } from './storage'
import type { UndoStack } from './undo'

const KEPT = 'key bindings'

export class SignalBoard {
  readonly sensors: KeySensors
  readonly #send: (command: Command) => boolean
  readonly #store: StudioStore
  readonly #undo: UndoStack
  readonly #listeners = new Set<() => void>()
  #storage: ProjectStorage | null = null

  constructor(send: (command: Command) => boolean, store: StudioStore, undo: UndoStack) {
    this.#send = send
    this.#store = store
    this.#undo = undo
    this.sensors = new KeySensors((signal, value) => this.#set(signal, value))
  }

  get armed(): boolean {
    return this.sensors.armed
  }

  get bindings(): readonly KeyBinding[] {
    return this.sensors.bindings
  }

  onChange(listener: () => void): () => void {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  /** Inputs of the cell; what was bound to them in this project comes back, others get a digit each. */
  setSignals(signals: readonly SignalDescription[], storage: ProjectStorage): void {
    this.#storage = storage
    const kept = readBindings(storage.read(KEPT))
    const inputs = signals.filter(one => one.input)
    this.sensors.bind(
      inputs.map((input, at) => {
        const rest = { signal: input.name, off: input.initial, on: input.initial === 0 ? 1 : 0 }
        const old = kept.find(one => one.signal === input.name)
        if (old) return { ...rest, ...old }
        const code = at < 9 ? `Digit${at + 1}` : ''
        return { ...rest, code, mode: input.analog ? ('ramp' as const) : ('hold' as const) }
      }),
    )
    this.#changed()
  }

  /** Change how a signal is set; can be undone. A key belongs to one signal. */
  rebind(signal: string, change: Partial<Omit<KeyBinding, 'signal'>>, name: string): void {
    const before = this.bindings
    const after = before.map(one => {
      if (one.signal === signal) return { ...one, ...change }
      return change.code && one.code === change.code ? { ...one, code: '' } : one
    })
    this.#undo.do({ name, undo: () => this.#bind(before), redo: () => this.#bind(after) })
  }

  arm(): void {
    this.sensors.arm()
    this.#changed()
  }

  disarm(): void {
    this.sensors.disarm()
    this.#changed()
  }

  press(signal: string): void {
    this.sensors.press(signal)
    this.#changed()
  }

  release(signal: string): void {
    this.sensors.release(signal)
    this.#changed()
  }

  /** A key of the page; true when it is a sensor's and must do nothing else. */
  key(event: KeyboardEvent): boolean {
    if (event.type === 'keyup') {
      const taken = this.sensors.keyUp(event.code)
      if (taken) this.#changed()
      return taken
    }
    if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target)) return false
    if (event.repeat) return this.armed && this.bindings.some(one => one.code === event.code)
    const taken = this.sensors.keyDown(event.code)
    if (taken) this.#changed()
    return taken
  }

  /** The page has lost the keyboard: nothing stays pressed. */
  blur(): void {
    this.sensors.releaseAll()
    this.#changed()
  }

  #set(name: string, value: number): void {
    const live = this.#store.getState().live
    if (live && live.state !== 'over') this.#send({ type: 'signal', name, value })
  }

  #bind(bindings: readonly KeyBinding[]): void {
    this.sensors.bind(bindings)
    this.#storage?.write(
      KEPT,
      bindings.map(({ signal, code, mode, on }) => ({ signal, code, mode, on })),
    )
    this.#changed()
  }

  #changed(): void {
    for (const listener of this.#listeners) listener()
  }
}

interface KeptBinding {
  readonly signal: string
  readonly code: string
  readonly mode: KeyMode
  readonly on: number
}

function readBindings(kept: unknown): readonly KeptBinding[] {
  return Array.isArray(kept) ? kept.filter(isKept) : []
}

function isKept(one: unknown): one is KeptBinding {
  const { signal, code, mode, on } = (one ?? {}) as Partial<KeptBinding>
  return (
    typeof signal === 'string' &&
    typeof code === 'string' &&
    typeof on === 'number' &&
    KEY_MODES.some(known => known === mode)
  )
}
