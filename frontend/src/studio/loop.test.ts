import { expect, test } from 'vitest'
import { Loop, type LoopClock } from './loop'

/** A browser whose frames and timers come when the test says so. */
class Frames implements LoopClock {
  waiting: ((now: number) => void) | null = null
  /** Whether the frame that is waited for leaves time before it. */
  calm = false
  timers: { milliseconds: number; act: () => void }[] = []

  frame = (act: (now: number) => void) => {
    this.waiting = act
    this.calm = false
  }

  calmFrame = (act: (now: number) => void) => {
    this.waiting = act
    this.calm = true
  }

  after = (milliseconds: number, act: () => void) => {
    const one = { milliseconds, act }
    this.timers.push(one)
    return () => {
      this.timers = this.timers.filter(other => other !== one)
    }
  }

  tick(now: number): boolean {
    const act = this.waiting
    this.waiting = null
    act?.(now)
    return act !== null
  }
}

test('an idle page asks for no frames', () => {
  const frames = new Frames()
  let shown = 0
  const loop = new Loop(
    () => false,
    () => shown++,
    frames,
  )
  loop.mark()
  expect(frames.tick(0)).toBe(true)
  expect(frames.waiting).toBeNull()
  expect(frames.timers).toHaveLength(0)
  expect(shown).toBe(1)
})

test('what comes from outside waits for a calm frame, playing goes on from frame to frame', () => {
  const frames = new Frames()
  let playing = true
  const loop = new Loop(
    () => playing,
    () => {},
    frames,
  )
  loop.mark()
  expect(frames.calm).toBe(true)
  frames.tick(0)
  expect(frames.waiting).not.toBeNull()
  expect(frames.calm).toBe(false)
  playing = false
  frames.tick(16)
  loop.mark()
  expect(frames.calm).toBe(true)
})

test('while it plays every frame lets the time pass that has passed, but never leaps', () => {
  const frames = new Frames()
  const passed: number[] = []
  const loop = new Loop(
    seconds => {
      passed.push(seconds)
      return true
    },
    () => {},
    frames,
  )
  loop.wake()
  for (const now of [1000, 1016, 1033, 9000]) frames.tick(now)
  expect(passed[0]).toBe(0)
  expect(passed[1]).toBeCloseTo(0.016, 9)
  expect(passed[2]).toBeCloseTo(0.017, 9)
  expect(passed[3]).toBe(0.25)
})

test('a listener of 10 Hz is called so often and sees the last change', () => {
  const frames = new Frames()
  const loop = new Loop(
    () => false,
    () => {},
    frames,
  )
  const calls: number[] = []
  let now = 0
  loop.every(10, () => calls.push(now))
  for (; now <= 1000; now += 16) {
    loop.mark()
    frames.tick(now)
  }
  expect(calls.length).toBeGreaterThanOrEqual(9)
  expect(calls.length).toBeLessThanOrEqual(12)
  expect(frames.timers).toHaveLength(1)
  frames.timers[0]?.act()
  now += 100
  const before = calls.length
  frames.tick(now)
  expect(calls).toHaveLength(before + 1)
})

test('nobody is called who has stopped listening', () => {
  const frames = new Frames()
  const loop = new Loop(
    () => false,
    () => {},
    frames,
  )
  let calls = 0
  const stop = loop.every(60, () => calls++)
  stop()
  loop.mark()
  frames.tick(0)
  expect(calls).toBe(0)
})

test('a frame that fails does not stop the clock for good', () => {
  const frames = new Frames()
  let shown = 0
  const loop = new Loop(
    () => false,
    () => {
      shown += 1
      if (shown === 1) throw new Error('a picture that cannot be drawn')
    },
    frames,
  )
  loop.mark()
  expect(() => frames.tick(0)).toThrow('cannot be drawn')
  loop.mark()
  expect(frames.tick(16)).toBe(true)
  expect(shown).toBe(2)
})
