/** The stretch of a run that the timeline shows, and where its times are across a width. */

/** The shortest stretch that is shown [s]: a few control ticks. */
export const SHORTEST = 0.02

/** Where a followed cursor comes to lie when the stretch moves on: this share from the left. */
const LEAD = 0.1

/** A stretch of time [s]. */
interface Stretch {
  readonly from: number
  readonly to: number
}

export class TimeWindow {
  #end = 0
  #from = 0
  #to = 0
  /** What the user has chosen, also where a run is too short for it; null for the whole run. */
  #chosen: Stretch | null = null

  get from(): number {
    return this.#from
  }

  get to(): number {
    return this.#to
  }

  /** Whether a part of the run is out of sight. */
  get zoomed(): boolean {
    return this.#from > 0 || this.#to < this.#end
  }

  /** The run has this length [s]: the chosen stretch stays, as far as the run has it, and returns with a longer one. */
  setEnd(end: number): void {
    this.#end = end
    if (this.#chosen) this.#clamp(this.#chosen.from, this.#chosen.to - this.#chosen.from)
    else this.fit()
  }

  fit(): void {
    this.#chosen = null
    this.#from = 0
    this.#to = this.#end
  }

  /** Show `factor` times less of the run around a time that stays where it is. */
  zoom(factor: number, about: number): void {
    const length = this.#to - this.#from
    const next = Math.min(Math.max(length / factor, Math.min(SHORTEST, this.#end)), this.#end)
    const share = length > 0 ? (about - this.#from) / length : 0.5
    this.#show(about - share * next, next)
  }

  /** Show what lies so much later [s]. */
  pan(by: number): void {
    this.#show(this.#from + by, this.#to - this.#from)
  }

  /** Move on where a time is out of sight; true when it was. */
  follow(time: number): boolean {
    if (!this.zoomed || (time >= this.#from && time <= this.#to)) return false
    const length = this.#to - this.#from
    this.#show(time > this.#to ? time - LEAD * length : time - (1 - LEAD) * length, length)
    return true
  }

  /** Place of a time across a width. */
  x(time: number, width: number): number {
    const length = this.#to - this.#from
    return length > 0 ? (width * (time - this.#from)) / length : 0
  }

  /** Time at a place across a width, within the run. */
  time(x: number, width: number): number {
    const time = this.#from + (x / Math.max(width, 1)) * (this.#to - this.#from)
    return Math.min(Math.max(time, 0), this.#end)
  }

  #show(from: number, length: number): void {
    this.#clamp(from, length)
    this.#chosen = this.zoomed ? { from: this.#from, to: this.#to } : null
  }

  #clamp(from: number, length: number): void {
    const shown = Math.min(length, this.#end)
    this.#from = Math.min(Math.max(from, 0), this.#end - shown)
    this.#to = this.#from + shown
  }
}
