/** The newest frames of a live run: rows of numbers with their times, in bounded memory. */
import { timesUpTo } from './search'

/** Ten minutes at 60 frames a second; older frames are forgotten, a quarter at once. */
const CAPACITY = 36_000
const FIRST = 1024

export class FrameStore {
  readonly width: number
  readonly #capacity: number
  #times = new Float64Array(FIRST)
  #rows: Float32Array
  #count = 0

  /** `width`: numbers in a row. */
  constructor(width: number, capacity = CAPACITY) {
    this.width = width
    this.#capacity = capacity
    this.#rows = new Float32Array(FIRST * width)
  }

  get count(): number {
    return this.#count
  }

  /** All rows behind each other; row k begins at k × `width`. Valid until the next row is added. */
  get rows(): Float32Array {
    return this.#rows
  }

  /** Time of the newest row, 0 for none [s]. */
  get last(): number {
    return this.#count > 0 ? (this.#times[this.#count - 1] ?? 0) : 0
  }

  /** Add a row of two parts; one that is not newer than the last is left out. Tells whether it was taken. */
  add(time: number, left: Float32Array, right: Float32Array): boolean {
    if (left.length + right.length !== this.width) return false
    if (this.#count > 0 && time <= this.last) return false
    this.#makeRoom()
    this.#times[this.#count] = time
    this.#rows.set(left, this.#count * this.width)
    this.#rows.set(right, this.#count * this.width + left.length)
    this.#count++
    return true
  }

  /** A copy of the times of some rows, or of all [s]. */
  times(from = 0, to = this.#count): Float64Array {
    return this.#times.slice(from, to)
  }

  /** A copy of one place of some rows, or of all. */
  column(place: number, from = 0, to = this.#count): Float64Array {
    return Float64Array.from({ length: to - from }, (_, k) => this.at(from + k, place))
  }

  at(row: number, place: number): number {
    return this.#rows[row * this.width + place] ?? Number.NaN
  }

  /** The row at or before a time, and the share of the way to the next one; clamped. */
  locate(time: number): { readonly index: number; readonly share: number } {
    const index = Math.max(timesUpTo(this.#times, time, this.#count) - 1, 0)
    const from = this.#times[index] ?? 0
    const to = index + 1 < this.#count ? (this.#times[index + 1] ?? from) : from
    return { index, share: to > from ? Math.min(Math.max((time - from) / (to - from), 0), 1) : 0 }
  }

  #makeRoom(): void {
    const room = this.#times.length
    if (this.#count < room) return
    if (room < this.#capacity) {
      const times = new Float64Array(Math.min(2 * room, this.#capacity))
      const rows = new Float32Array(times.length * this.width)
      times.set(this.#times)
      rows.set(this.#rows)
      this.#times = times
      this.#rows = rows
      return
    }
    const dropped = Math.ceil(room / 4)
    this.#times.copyWithin(0, dropped)
    this.#rows.copyWithin(0, dropped * this.width)
    this.#count -= dropped
  }
}
