/** Keys as sensors of the cell: a bound key sets an input while the switch is armed. */

/**
 * `hold`: on while the key is down. `toggle`: each press changes it. `pulse`: on for a short time.
 * `ramp`: rises while the key is down and falls after it.
 */
export const KEY_MODES = ['hold', 'toggle', 'pulse', 'ramp'] as const
export type KeyMode = (typeof KEY_MODES)[number]

export interface KeyBinding {
  readonly signal: string
  /** Physical key (`event.code`); empty: by button only. */
  readonly code: string
  readonly mode: KeyMode
  /** Value at rest and value when set. */
  readonly off: number
  readonly on: number
}

export interface SensorTimers {
  readonly after: (milliseconds: number, act: () => void) => () => void
}

/** Length of a pulse, time of a full ramp and of one step of it [ms]. */
export const PULSE = 250
export const RAMP = 1000
export const RAMP_STEP = 50

export class KeySensors {
  readonly #set: (signal: string, value: number) => void
  readonly #timers: SensorTimers
  readonly #values = new Map<string, number>()
  readonly #down = new Set<string>()
  readonly #waits = new Map<string, () => void>()
  #bindings: readonly KeyBinding[] = []
  #armed = false

  constructor(set: (signal: string, value: number) => void, timers: SensorTimers = browserTimers) {
    this.#set = set
    this.#timers = timers
  }

  get armed(): boolean {
    return this.#armed
  }

  get bindings(): readonly KeyBinding[] {
    return this.#bindings
  }

  /** Value that this page has given a signal; undefined before the first press. */
  value(signal: string): number | undefined {
    return this.#values.get(signal)
  }

  bind(bindings: readonly KeyBinding[]): void {
    this.releaseAll()
    this.#bindings = bindings
  }

  arm(): void {
    this.#armed = true
  }

  disarm(): void {
    this.releaseAll()
    this.#armed = false
  }

  /** A key goes down; true when it is a sensor's. Repeats of a held key change nothing. */
  keyDown(code: string): boolean {
    const bound = this.#bindings.filter(one => one.code === code && code !== '')
    if (!this.#armed || bound.length === 0) return false
    for (const one of bound) this.press(one.signal)
    return true
  }

  keyUp(code: string): boolean {
    const bound = this.#bindings.filter(one => one.code === code && code !== '')
    for (const one of bound) this.release(one.signal)
    return this.#armed && bound.length > 0
  }

  /** Press the button of a signal, whether armed or not. */
  press(signal: string): void {
    const binding = this.#bindings.find(one => one.signal === signal)
    if (!binding || this.#down.has(signal)) return
    this.#down.add(signal)
    if (binding.mode === 'toggle') {
      this.#give(binding, this.#now(binding) === binding.off ? binding.on : binding.off)
    } else if (binding.mode === 'ramp') {
      this.#ramp(binding, 1)
    } else {
      this.#give(binding, binding.on)
      if (binding.mode === 'pulse') this.#wait(binding, PULSE, () => this.#give(binding, binding.off))
    }
  }

  release(signal: string): void {
    const binding = this.#bindings.find(one => one.signal === signal)
    if (!binding || !this.#down.delete(signal)) return
    if (binding.mode === 'hold') this.#give(binding, binding.off)
    if (binding.mode === 'ramp') this.#ramp(binding, -1)
  }

  /** Everything back to rest: the switch is off or the page has lost the keyboard. */
  releaseAll(): void {
    for (const cancel of this.#waits.values()) cancel()
    this.#waits.clear()
    this.#down.clear()
    for (const binding of this.#bindings) {
      if (this.#now(binding) !== binding.off) this.#give(binding, binding.off)
    }
  }

  #now(binding: KeyBinding): number {
    return this.#values.get(binding.signal) ?? binding.off
  }

  #ramp(binding: KeyBinding, direction: 1 | -1): void {
    const goal = direction === 1 ? binding.on : binding.off
    const step = (Math.abs(binding.on - binding.off) * RAMP_STEP) / RAMP
    const now = this.#now(binding)
    if (now === goal) return
    const next = Math.abs(goal - now) <= step * 1.000001 ? goal : now + Math.sign(goal - now) * step
    this.#give(binding, next)
    if (next !== goal) this.#wait(binding, RAMP_STEP, () => this.#ramp(binding, direction))
  }

  #give(binding: KeyBinding, value: number): void {
    this.#values.set(binding.signal, value)
    this.#set(binding.signal, value)
  }

  #wait(binding: KeyBinding, milliseconds: number, act: () => void): void {
    this.#waits.get(binding.signal)?.()
    this.#waits.set(binding.signal, this.#timers.after(milliseconds, act))
  }
}

const browserTimers: SensorTimers = {
  after: (milliseconds, act) => {
    const timer = setTimeout(act, milliseconds)
    return () => clearTimeout(timer)
  },
}
