/** Where the viewports of each layout lie. */
import type { Layout } from './settings'

/** In CSS px from the top left of the stage. */
export interface Rect {
  readonly x: number
  readonly y: number
  readonly width: number
  readonly height: number
}

/** Names of the places, in order; each layout uses the first ones. */
export const PLACES = ['perspective', 'top', 'front', 'right'] as const

/** Between viewports [px]. */
const GAP = 2

/** Columns of rows, with shares of width and height. */
const SHARES: Record<Layout, readonly (readonly [number, number, number, number])[]> = {
  '1': [[0, 0, 1, 1]],
  '2': [
    [0, 0, 1 / 2, 1],
    [1 / 2, 0, 1, 1],
  ],
  '4': [
    [0, 0, 1 / 2, 1 / 2],
    [1 / 2, 0, 1, 1 / 2],
    [0, 1 / 2, 1 / 2, 1],
    [1 / 2, 1 / 2, 1, 1],
  ],
  '3+1': [
    [0, 0, 2 / 3, 1],
    [2 / 3, 0, 1, 1 / 3],
    [2 / 3, 1 / 3, 1, 2 / 3],
    [2 / 3, 2 / 3, 1, 1],
  ],
}

/** A lower viewport shows nothing beside its buttons [px]. */
const LOWEST = 100

/** Whole pixels that fill the stage but for gaps; one viewport has all of a stage that is too low for the layout. */
export function rectsOf(layout: Layout, width: number, height: number): Rect[] {
  const rects = dividedBy(layout, width, height)
  return rects.some(rect => rect.height < LOWEST) ? dividedBy('1', width, height) : rects
}

function dividedBy(layout: Layout, width: number, height: number): Rect[] {
  const low = (share: number, size: number) => (share === 0 ? 0 : Math.round(share * size + GAP / 2))
  const high = (share: number, size: number) => (share === 1 ? size : Math.round(share * size - GAP / 2))
  return SHARES[layout].map(([left, top, right, bottom]) => {
    const [x, y] = [low(left, width), low(top, height)]
    return { x, y, width: Math.max(0, high(right, width) - x), height: Math.max(0, high(bottom, height) - y) }
  })
}
