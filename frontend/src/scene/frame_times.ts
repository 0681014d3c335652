/** Times of the last frames on the main thread. */

const KEPT = 300

export class FrameTimes {
  readonly #times = new Float64Array(KEPT)
  #count = 0

  get count(): number {
    return this.#count
  }

  /** [ms] */
  add(time: number): void {
    this.#times[this.#count % KEPT] = time
    this.#count += 1
  }

  /** The time that a share of the kept frames does not exceed [ms]; 0 before the first. */
  quantile(share: number): number {
    const kept = this.#times.slice(0, Math.min(this.#count, KEPT)).sort()
    return kept[Math.min(kept.length - 1, Math.floor(share * kept.length))] ?? 0
  }
}
