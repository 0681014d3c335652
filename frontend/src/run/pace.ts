/** How quickly a live run really goes: simulated seconds per second of the clock on the wall, over a while. */

/** Time over which it is measured, and the least of it that says something [ms]. */
const WHILE = 2000
const LEAST = 1000
/** Share of the wanted pace from which on a run keeps it: frames come in steps. */
const KEPT = 0.9

export class Pace {
  #samples: { readonly time: number; readonly wall: number }[] = []

  /** A frame with its simulated time [s] and the time of the server's clock [ms]. */
  add(time: number, wall: number): void {
    const last = this.#samples.at(-1)
    if (last && (time < last.time || wall < last.wall)) this.#samples = []
    this.#samples.push({ time, wall })
    // The oldest one stays until the next is a while old: the span measured is a while at least.
    while ((this.#samples[1]?.wall ?? wall) <= wall - WHILE) this.#samples.shift()
  }

  reset(): void {
    this.#samples = []
  }

  /** Simulated seconds per second, to a tenth; null while too little is known. */
  get value(): number | null {
    const [first, last] = [this.#samples[0], this.#samples.at(-1)]
    if (!first || !last || last.wall - first.wall < LEAST) return null
    return Math.round((10_000 * (last.time - first.time)) / (last.wall - first.wall)) / 10
  }
}

/** Whether a run is behind the pace that is wanted of it. */
export function isBehind(pace: number | null, wanted: number): pace is number {
  return pace !== null && pace < KEPT * wanted
}
