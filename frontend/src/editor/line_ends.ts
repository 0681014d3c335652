/** Line ends of a text while it is edited: what was not touched keeps its own, byte for byte. */
import type { ChangeDesc, Text } from '@codemirror/state'

const BREAK = /\r\n|\n|\r/g

export class LineEnds {
  #ends: readonly string[]
  readonly #usual: string

  constructor(text: string) {
    this.#ends = text.match(BREAK) ?? []
    const count = (end: string) => this.#ends.filter(one => one === end).length
    this.#usual = ['\n', '\r\n', '\r'].reduce((best, end) => (count(end) > count(best) ? end : best))
  }

  /** Follow a change of the document; new lines get the line end that most lines have. */
  change(before: Text, after: Text, changes: ChangeDesc): void {
    const ends: string[] = []
    let kept = 1
    changes.iterChangedRanges((fromA, toA, fromB, toB) => {
      const first = before.lineAt(fromA).number
      ends.push(...this.#ends.slice(kept - 1, first - 1))
      const inserted = after.lineAt(toB).number - after.lineAt(fromB).number
      for (let k = 0; k < inserted; k += 1) ends.push(this.#usual)
      kept = before.lineAt(toA).number
    })
    this.#ends = [...ends, ...this.#ends.slice(kept - 1)]
  }

  /** The whole text with its line ends. */
  text(doc: Text): string {
    if (this.#ends.every(end => end === '\n')) return doc.toString()
    const parts: string[] = []
    let number = 0
    for (const line of doc.iterLines()) {
      if (number > 0) parts.push(this.#ends[number - 1] ?? this.#usual)
      parts.push(line)
      number += 1
    }
    return parts.join('')
  }
}
