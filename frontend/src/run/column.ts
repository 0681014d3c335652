/** One column of a pack over time; bytes are decoded when a column is first asked for. */
import { type ColumnCode, PackError } from './pack_file'
import type { Series } from './run'
import { timesUpTo } from './search'

/** When the samples of a pack are: equally spaced, the last one at the end of the run. */
export class Clock {
  readonly rate: number
  readonly duration: number
  readonly count: number
  #times: Float64Array | undefined

  constructor(rate: number, duration: number, count: number) {
    this.rate = rate
    this.duration = duration
    this.count = count
  }

  get times(): Float64Array {
    this.#times ??= Float64Array.from({ length: this.count }, (_, k) => this.at(k))
    return this.#times
  }

  /** The sample at or before a time, and the share of the way to the next one. */
  locate(time: number): { readonly index: number; readonly share: number } {
    const clamped = Math.min(Math.max(time, 0), this.duration)
    const index = Math.max(Math.min(Math.floor(clamped * this.rate), this.count - 2), 0)
    const span = this.at(index + 1) - this.at(index)
    return { index, share: span > 0 ? Math.min((clamped - this.at(index)) / span, 1) : 0 }
  }

  private at(index: number): number {
    return Math.min(index / this.rate, this.duration)
  }
}

export class Column {
  readonly #code: ColumnCode
  readonly #body: Uint8Array
  readonly #clock: Clock
  #series: Series | undefined

  constructor(code: ColumnCode, body: Uint8Array, clock: Clock) {
    this.#code = code
    this.#body = body
    this.#clock = clock
  }

  /** Value at a time, clamped to the run; NaN in gaps. */
  value(time: number): number {
    if (this.#code.kind === 'constant') return this.#code.value ?? Number.NaN
    const { times, values, held } = this.series
    if (held) return values[Math.max(timesUpTo(times, time) - 1, 0)] ?? Number.NaN
    const { index, share } = this.#clock.locate(time)
    const from = values[index] ?? Number.NaN
    const to = values[index + 1] ?? from
    if (share === 0) return from
    return share === 1 ? to : from + (to - from) * share
  }

  get series(): Series {
    this.#series ??= this.#decode()
    return this.#series
  }

  #decode(): Series {
    const code = this.#code
    const clock = this.#clock
    switch (code.kind) {
      case 'constant': {
        const value = code.value ?? Number.NaN
        return {
          times: Float64Array.of(0, clock.duration),
          values: Float64Array.of(value, value),
          held: true,
        }
      }
      case 'steps':
        return {
          times: Float64Array.from(code.times),
          values: Float64Array.from(code.values, value => value ?? Number.NaN),
          held: true,
        }
      case 'smooth': {
        const bytes = this.#body.subarray(code.offset, code.offset + code.length)
        const values = smoothValues(bytes, clock.count, code.step)
        for (const [from, to] of code.gaps) values.fill(Number.NaN, from, to)
        return { times: clock.times, values, held: false }
      }
    }
  }
}

/** Undo second differences, zigzag and LEB128. */
export function smoothValues(bytes: Uint8Array, count: number, step: number): Float64Array {
  const values = new Float64Array(count)
  let at = 0
  let slope = 0
  let whole = 0
  for (let k = 0; k < count; k++) {
    let number = 0
    let weight = 1
    let byte: number
    do {
      // Multiplying instead of shifting: the numbers may be longer than 32 bits.
      byte = bytes[at++] ?? -1
      if (byte < 0) throw new PackError('The recorded run is damaged: a column is cut off.')
      number += (byte & 0x7f) * weight
      weight *= 128
    } while (byte >= 0x80)
    slope += number % 2 === 0 ? number / 2 : -(number + 1) / 2
    whole += slope
    values[k] = whole * step
  }
  return values
}
