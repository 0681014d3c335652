/** Keeps a line of the text in sight while it changes, unless the user is busy with the text. */

/** After a key, a click or a turn of the wheel the text stays where the user has put it for so long [ms]. */
export const PATIENCE = 4000

/** Room that stays above and below the line [px]. */
const MARGIN = 40

/** What is asked of the editor: where lines are [px of the text], and what of them is seen. */
export interface Sight {
  readonly block: (line: number) => { readonly top: number; readonly bottom: number }
  readonly seen: () => { readonly top: number; readonly bottom: number }
  readonly scroll: (line: number, margin: number) => void
}

export class LineInSight {
  readonly #sight: Sight
  readonly #clock: () => number
  #touched = Number.NEGATIVE_INFINITY

  constructor(sight: Sight, clock: () => number = () => performance.now()) {
    this.#sight = sight
    this.#clock = clock
  }

  /** The user types, clicks or scrolls. */
  touch(): void {
    this.#touched = this.#clock()
  }

  /** Bring a line into sight where it is not, as far as needed and no farther. */
  show(line: number): void {
    if (this.#clock() - this.#touched < PATIENCE) return
    const [block, seen] = [this.#sight.block(line), this.#sight.seen()]
    if (block.top >= seen.top && block.bottom <= seen.bottom) return
    const room = (seen.bottom - seen.top - (block.bottom - block.top)) / 2
    this.#sight.scroll(line, Math.max(0, Math.min(MARGIN, room)))
  }
}
