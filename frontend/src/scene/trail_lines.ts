/** The paths of the tools of all stations, drawn alike: a line for each. */
import type { Color, Object3D } from 'three'
import type { PathWindow, Trail } from './settings'
import { TrailLine } from './trail_line'

export class TrailLines {
  readonly #parent: Object3D
  readonly #strength: number
  readonly #lines: TrailLine[] = []
  #colour: Color | null = null

  constructor(parent: Object3D, strength: number) {
    this.#parent = parent
    this.#strength = strength
  }

  set colour(colour: Color) {
    this.#colour = colour
    for (const line of this.#lines) line.colour = colour
  }

  /** Draw these paths, one of each station, and no other ones. */
  set(trails: readonly Trail[]): void {
    while (this.#lines.length < trails.length) {
      const line = new TrailLine(this.#parent, this.#strength)
      if (this.#colour) line.colour = this.#colour
      this.#lines.push(line)
    }
    for (const [at, line] of this.#lines.entries()) line.set(trails[at] ?? null)
  }

  /** How much of each path is drawn; whether anything is different from before. */
  setWindows(windows: readonly PathWindow[]): boolean {
    return this.#lines
      .map((line, at) => {
        const window = windows[at]
        return window !== undefined && line.setWindow(window)
      })
      .includes(true)
  }

  dispose(): void {
    for (const line of this.#lines) line.dispose()
    this.#lines.length = 0
  }
}
