import { expect, test } from 'vitest'
import { type KeyBinding, type KeyMode, KeySensors, PULSE, RAMP, RAMP_STEP } from './key_sensors'

/** Timers that run when the test says so. */
class Clock {
  now = 0
  #waiting: { at: number; act: () => void }[] = []

  after = (milliseconds: number, act: () => void) => {
    const one = { at: this.now + milliseconds, act }
    this.#waiting.push(one)
    return () => {
      this.#waiting = this.#waiting.filter(other => other !== one)
    }
  }

  pass(milliseconds: number): void {
    const end = this.now + milliseconds
    for (;;) {
      const next = this.#waiting.sort((a, b) => a.at - b.at)[0]
      if (!next || next.at > end) break
      this.#waiting.shift()
      this.now = next.at
      next.act()
    }
    this.now = end
  }
}

function bench(mode: KeyMode, change: Partial<KeyBinding> = {}) {
  const clock = new Clock()
  const given: number[] = []
  const sensors = new KeySensors((_, value) => given.push(value), clock)
  sensors.bind([{ signal: 's', code: 'KeyA', mode, off: 0, on: 1, ...change }])
  return { clock, given, sensors }
}

test('keys do nothing until they are armed', () => {
  const { sensors, given } = bench('hold')
  expect(sensors.keyDown('KeyA')).toBe(false)
  expect(given).toEqual([])
  sensors.arm()
  expect(sensors.keyDown('KeyA')).toBe(true)
  expect(sensors.keyDown('KeyB')).toBe(false)
  expect(given).toEqual([1])
})

test('hold: on while the key is down; repeats change nothing', () => {
  const { sensors, given } = bench('hold')
  sensors.arm()
  for (let times = 0; times < 5; times++) sensors.keyDown('KeyA')
  sensors.keyUp('KeyA')
  sensors.keyUp('KeyA')
  expect(given).toEqual([1, 0])
})

test('toggle: each press changes it', () => {
  const { sensors, given } = bench('toggle')
  sensors.arm()
  for (let times = 0; times < 3; times++) {
    sensors.keyDown('KeyA')
    sensors.keyUp('KeyA')
  }
  expect(given).toEqual([1, 0, 1])
})

test('pulse: on for a fixed time, however long the key is held', () => {
  const { sensors, given, clock } = bench('pulse')
  sensors.arm()
  sensors.keyDown('KeyA')
  clock.pass(PULSE - 1)
  expect(given).toEqual([1])
  clock.pass(1)
  sensors.keyUp('KeyA')
  clock.pass(10 * PULSE)
  expect(given).toEqual([1, 0])
})

test('ramp: rises in a second, stays, and falls after release', () => {
  const { sensors, given, clock } = bench('ramp', { on: 10 })
  sensors.arm()
  sensors.keyDown('KeyA')
  clock.pass(RAMP / 2 - RAMP_STEP)
  expect(sensors.value('s')).toBeCloseTo(5, 9)
  clock.pass(2 * RAMP)
  expect(sensors.value('s')).toBe(10)
  const steps = given.length
  sensors.keyUp('KeyA')
  clock.pass(2 * RAMP)
  expect(sensors.value('s')).toBe(0)
  expect(given.slice(0, steps)).toEqual([...given.slice(0, steps)].sort((a, b) => a - b))
})

test('an input that is on at rest is turned off by its key', () => {
  const { sensors, given } = bench('hold', { off: 1, on: 0 })
  sensors.arm()
  sensors.keyDown('KeyA')
  sensors.keyUp('KeyA')
  expect(given).toEqual([0, 1])
})

test.each(['hold', 'toggle', 'ramp'] as const)('disarming lets go of everything (%s)', mode => {
  const { sensors, given, clock } = bench(mode)
  sensors.arm()
  sensors.keyDown('KeyA')
  clock.pass(RAMP_STEP)
  sensors.disarm()
  expect(given.at(-1)).toBe(0)
  const count = given.length
  clock.pass(10 * RAMP)
  sensors.keyUp('KeyA')
  expect(given).toHaveLength(count)
})

test('losing the keyboard lets go but stays armed, and a new press works', () => {
  const { sensors, given } = bench('hold')
  sensors.arm()
  sensors.keyDown('KeyA')
  sensors.releaseAll()
  sensors.keyDown('KeyA')
  expect(given).toEqual([1, 0, 1])
  expect(sensors.armed).toBe(true)
})

test('the button on the page works without arming', () => {
  const { sensors, given } = bench('hold', { code: '' })
  sensors.press('s')
  sensors.release('s')
  expect(given).toEqual([1, 0])
})
