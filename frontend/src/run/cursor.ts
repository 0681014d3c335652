/** The one time cursor: every view, plot and table shows the run at this time. */

export type CursorListener = (time: number) => void

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8] as const

export class Cursor {
  #time = 0
  #end = 0
  #playing = false
  #speed = 1
  #loop: readonly [number, number] | null = null
  readonly #listeners = new Set<CursorListener>()
  readonly #changes = new Set<() => void>()

  get time(): number {
    return this.#time
  }

  get end(): number {
    return this.#end
  }

  get playing(): boolean {
    return this.#playing
  }

  get speed(): number {
    return this.#speed
  }

  /** The range that is repeated while playing, or null. */
  get loop(): readonly [number, number] | null {
    return this.#loop
  }

  /** Hear of every new time (up to once a frame). Returns the way to stop that. */
  onTime(listener: CursorListener): () => void {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  /** Hear of play, pause, speed, loop and end: rare, fit for user interface state. */
  onChange(listener: () => void): () => void {
    this.#changes.add(listener)
    return () => this.#changes.delete(listener)
  }

  /** The run has this length [s] now; a cursor beyond it comes back to it, and so does the loop. */
  setEnd(end: number): void {
    if (end === this.#end) return
    if (this.#loop) {
      const [from, to] = this.#loop
      // Who repeats the whole run repeats the whole of the next one, too.
      this.#loop = from === 0 && to === this.#end ? stretch(0, end) : stretch(from, Math.min(to, end))
    }
    this.#end = end
    if (this.#time > end) this.#move(end)
    this.#changed()
  }

  /** Go to a time [s]; it is clamped to the run. */
  seek(time: number): void {
    if (Number.isFinite(time)) this.#move(Math.min(Math.max(time, 0), this.#end))
  }

  play(): void {
    if (this.#playing || this.#end === 0) return
    if (this.#time >= this.#end) this.#move(0)
    this.#playing = true
    this.#changed()
  }

  pause(): void {
    if (!this.#playing) return
    this.#playing = false
    this.#changed()
  }

  setSpeed(speed: number): void {
    this.#speed = speed
    this.#changed()
  }

  /** Repeat a stretch of the run; null, and a stretch of no length, for none. */
  setLoop(range: readonly [number, number] | null): void {
    this.#loop = range && stretch(Math.max(range[0], 0), Math.min(range[1], this.#end))
    this.#changed()
  }

  /** Let `seconds` of wall time pass; called once a frame by whoever owns the clock. */
  advance(seconds: number): void {
    if (!this.#playing) return
    const [from, to] = this.#loop ?? [0, this.#end]
    const next = this.#time + seconds * this.#speed
    if (next < to) {
      this.#move(next)
    } else if (this.#loop) {
      this.#move(from)
    } else {
      this.#move(this.#end)
      this.pause()
    }
  }

  #move(time: number): void {
    if (time === this.#time) return
    this.#time = time
    for (const listener of this.#listeners) listener(time)
  }

  #changed(): void {
    for (const listener of this.#changes) listener()
  }
}

function stretch(from: number, to: number): readonly [number, number] | null {
  return to > from ? [from, to] : null
}
