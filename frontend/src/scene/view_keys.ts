/** Keys of a viewport; they act only while it has the focus. */
import type { Pilot } from './pilot'

export interface KeyActions {
  readonly fitSelection: () => void
  readonly fitAll: () => void
}

export type Key = Pick<KeyboardEvent, 'key' | 'shiftKey' | 'ctrlKey' | 'metaKey' | 'altKey'>

const TURN = Math.PI / 24
const MOVE = 0.05
const NEARER = 0.85

/** Do what a key asks for; false when it asks for nothing here. */
export function pressKey(pilot: Pilot, event: Key, actions: KeyActions): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false
  const arrow = ARROWS[event.key]
  if (arrow) {
    const [right, up] = arrow
    pilot.anchorInMiddle()
    if (event.shiftKey) pilot.move(-MOVE * right, -MOVE * up)
    else pilot.turn(TURN * right, TURN * up)
    return true
  }
  const act = keys(pilot, actions)[event.key.length === 1 ? event.key.toLowerCase() : event.key]
  act?.()
  return act !== undefined
}

const ARROWS: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}

function keys(pilot: Pilot, { fitSelection, fitAll }: KeyActions): Record<string, () => void> {
  const zoom = (factor: number) => () => {
    pilot.anchorInMiddle()
    pilot.zoom(factor)
  }
  return {
    f: fitSelection,
    Home: fitAll,
    '1': () => pilot.look('front'),
    '3': () => pilot.look('right'),
    '7': () => pilot.look('top'),
    '0': () => pilot.look('perspective'),
    '5': () => pilot.switchProjection(),
    '+': zoom(NEARER),
    '=': zoom(NEARER),
    '-': zoom(1 / NEARER),
  }
}
