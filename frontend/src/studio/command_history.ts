/** Lines that were typed before: the older and the newer one, as a terminal has them. */

/** So many are kept, the newest. */
const MOST = 200

export class CommandHistory {
  #lines: readonly string[]
  /** Where one looks: the number of lines at the line that is being typed. */
  #at: number
  /** What was being typed when one began to look back. */
  #draft = ''

  constructor(kept: unknown) {
    this.#lines = Array.isArray(kept) ? kept.filter(one => typeof one === 'string').slice(-MOST) : []
    this.#at = this.#lines.length
  }

  get lines(): readonly string[] {
    return this.#lines
  }

  /** Keep a line; the same one twice in a row is kept once, a blank one not at all. */
  add(line: string): void {
    if (line.trim() && line !== this.#lines.at(-1)) this.#lines = [...this.#lines, line].slice(-MOST)
    this.#at = this.#lines.length
    this.#draft = ''
  }

  /** The line before the one that is shown; null where there is none. */
  older(shown: string): string | null {
    if (this.#at === 0) return null
    if (this.#at === this.#lines.length) this.#draft = shown
    this.#at -= 1
    return this.#lines[this.#at] ?? null
  }

  /** The line after the one that is shown, at last what was being typed; null where there is none. */
  newer(): string | null {
    if (this.#at === this.#lines.length) return null
    this.#at += 1
    return this.#lines[this.#at] ?? this.#draft
  }
}
