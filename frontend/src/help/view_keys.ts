/** The keys and drags of a 3-D view, for the key sheet; `view_keys.test.ts` holds them against what acts. */
import { helpWords as words } from './words'

export const VIEW_KEYS: readonly (readonly [keys: readonly string[], title: string])[] = [
  [['F'], words.view.fit],
  [['Home'], words.view.home],
  [['1', '3', '7'], words.view.sides],
  [['0'], words.view.perspective],
  [['5'], words.view.projection],
  [['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'], words.view.turn],
  [['Shift+ArrowLeft', 'Shift+ArrowRight', 'Shift+ArrowUp', 'Shift+ArrowDown'], words.view.shift],
  [['+', '-'], words.view.zoom],
]

export const VIEW_DRAGS: readonly (readonly [gesture: string, title: string])[] = [
  [words.drag.left, words.view.turnAbout],
  [words.drag.right, words.view.shift],
  [words.drag.wheel, words.view.zoomTo],
]
