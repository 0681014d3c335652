import { beforeEach, describe, expect, it } from 'vitest'
import { Cursor } from './cursor'
import type { Run } from './run'
import { Transport } from './transport'

const span = { source: 'main.task', line: 1, column: 1, end_line: 1, end_column: 2 }
const run = {
  stations: [{ name: '', program: 'main', source: 'main.task' }],
  events: [1, 4, 7].map(time => ({ time, duration: 1, kind: 'move', text: '', station: '', span, data: {} })),
  channels: [],
  findings: [{ code: 'X1', severity: 'warning', message: '', hint: '', span: null, time: 5 }],
} as unknown as Run

let transport: Transport
beforeEach(() => {
  transport = new Transport(new Cursor())
  transport.cursor.setEnd(10)
  transport.show(run)
})

function press(key: string, held: Partial<KeyboardEvent> = {}): boolean {
  const none = { ctrlKey: false, metaKey: false, altKey: false, shiftKey: false }
  return transport.key({ key, ...none, ...held })
}

function timesAfter(keys: readonly string[], held: Partial<KeyboardEvent> = {}): number[] {
  return keys.map(key => {
    press(key, held)
    return transport.cursor.time
  })
}

describe('keys of the timeline', () => {
  it('go from step to step and stop at the ends', () => {
    const right = 'ArrowRight'
    expect(timesAfter([right, right, right, right, right])).toEqual([1, 4, 7, 10, 10])
    const left = 'ArrowLeft'
    expect(timesAfter([left, left, left, left])).toEqual([7, 4, 1, 0])
  })

  it('go from step to step with comma and full stop, too: arrows turn the 3-D views', () => {
    expect(timesAfter(['.', '.', ','])).toEqual([1, 4, 1])
  })

  it('go to findings with Shift, and nowhere where there is none', () => {
    expect(timesAfter(['ArrowRight', 'ArrowRight'], { shiftKey: true })).toEqual([5, 5])
    press('End')
    expect(timesAfter(['ArrowLeft', 'ArrowLeft'], { shiftKey: true })).toEqual([5, 5])
  })

  it('go by seconds and to the ends', () => {
    expect(timesAfter(['PageUp', 'PageUp', 'PageDown', 'End', 'Home'])).toEqual([1, 2, 1, 10, 0])
  })

  it('pause where they go', () => {
    press(' ')
    expect(transport.cursor.playing).toBe(true)
    press('PageUp')
    expect(transport.cursor.playing).toBe(false)
  })

  it('choose the repeated stretch from both sides', () => {
    transport.cursor.seek(3)
    press('[')
    expect(transport.cursor.loop).toEqual([3, 10])
    transport.cursor.seek(6)
    press(']')
    expect(transport.cursor.loop).toEqual([3, 6])
    transport.cursor.seek(8)
    press('[')
    expect(transport.cursor.loop).toEqual([8, 10])
    transport.cursor.seek(2)
    press(']')
    expect(transport.cursor.loop).toEqual([0, 2])
  })

  it('leave commands alone, but take brackets that need AltGr', () => {
    expect(press('Home', { ctrlKey: true })).toBe(false)
    expect(press('x')).toBe(false)
    transport.cursor.seek(3)
    expect(press('[', { ctrlKey: true, altKey: true, getModifierState: key => key === 'AltGraph' })).toBe(
      true,
    )
    expect(transport.cursor.loop).toEqual([3, 10])
  })
})

it('without a run steps lead to the ends', () => {
  transport.show(null)
  transport.nextStep()
  expect(transport.cursor.time).toBe(10)
  transport.previousFinding()
  expect(transport.cursor.time).toBe(10)
  transport.previousStep()
  expect(transport.cursor.time).toBe(0)
})

it('takes presses of keys of a live run into the marks', () => {
  const events: Run['events'][number][] = []
  transport.show({ stations: [], events, findings: [], channels: [] } as unknown as Run)
  const before = transport.marks
  expect(transport.marks).toBe(before)
  events.push({ time: 2, duration: 0, kind: 'input', text: 'start = 1', station: '', span: null, data: {} })
  expect(transport.marks.inputs).toEqual([{ time: 2, text: 'start = 1' }])
})

it('plays and pauses a live run instead of the cursor while there is one', () => {
  let playing = true
  const player = {
    get playing() {
      return playing
    },
    toggle: () => {
      playing = !playing
    },
  }
  transport.drive(player)
  expect(transport.playing).toBe(true)
  press(' ')
  expect([playing, transport.playing, transport.cursor.playing]).toEqual([false, false, false])
  transport.drive(null)
  press(' ')
  expect([playing, transport.cursor.playing]).toEqual([false, true])
})
