import { afterEach, beforeEach, expect, it, vi } from 'vitest'

/** A browser whose frames come when the test says so. */
let frames: Map<number, (now: number) => void>

beforeEach(() => {
  frames = new Map()
  let asked = 0
  vi.resetModules()
  vi.useFakeTimers()
  vi.stubGlobal('requestAnimationFrame', (act: (now: number) => void) => {
    frames.set(++asked, act)
    return asked
  })
  vi.stubGlobal('cancelAnimationFrame', (handle: number) => frames.delete(handle))
})

afterEach(() => {
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

/** What asks for frames in a browser with graphics of this name. */
async function onNextFrame(graphics: string) {
  const context = { getExtension: () => null, getParameter: () => graphics, RENDERER: 0 }
  vi.stubGlobal('document', { createElement: () => ({ getContext: () => context }) })
  return (await import('./next_frame')).onNextFrame
}

it('asks at once where the graphics draw', async () => {
  const ask = await onNextFrame('a fast card')
  ask(() => {})
  expect(frames.size).toBe(1)
})

it('lets messages in before it asks where the processor draws', async () => {
  const ask = await onNextFrame('SwiftShader')
  const acted: number[] = []
  ask(now => acted.push(now))
  expect(frames.size).toBe(0)
  vi.runAllTimers()
  for (const act of frames.values()) act(7)
  expect(acted).toEqual([7])
})

it('is called off before and after the breath', async () => {
  const ask = await onNextFrame('SwiftShader')
  ask(() => {})()
  vi.runAllTimers()
  expect(frames.size).toBe(0)
  const callOff = ask(() => {})
  vi.runAllTimers()
  expect(frames.size).toBe(1)
  callOff()
  expect(frames.size).toBe(0)
})
