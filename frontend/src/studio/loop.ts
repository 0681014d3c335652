/** The page's clock: one animation frame at a time, and only while there is something to do. */
import { onNextFrame } from '../scene/next_frame'

export interface LoopClock {
  /** The very next animation frame. */
  readonly frame: (act: (now: number) => void) => void
  /** One that lets messages and input in before it, where drawing holds the page up. */
  readonly calmFrame: (act: (now: number) => void) => void
  readonly after: (milliseconds: number, act: () => void) => () => void
}

interface Subscriber {
  readonly period: number
  readonly act: () => void
  last: number
  due: boolean
}

/** Longest time that one frame lets pass [s]: a page that slept does not leap. */
const LONGEST = 0.25

export class Loop {
  readonly #advance: (seconds: number) => boolean
  readonly #show: () => void
  readonly #clock: LoopClock
  readonly #subscribers = new Set<Subscriber>()
  #asked = false
  #last: number | null = null
  #dirty = false
  #inside = false
  #cancelWait: () => void = () => {}

  /**
   * @param advance lets wall time pass [s] and says whether it wants more frames
   * @param show draws what has changed
   */
  constructor(advance: (seconds: number) => boolean, show: () => void, clock: LoopClock = browserClock) {
    this.#advance = advance
    this.#show = show
    this.#clock = clock
  }

  /** Something that is shown has changed. */
  mark(): void {
    this.#dirty = true
    for (const one of this.#subscribers) one.due = true
    this.wake()
  }

  wake(): void {
    if (this.#asked || this.#inside) return
    this.#cancelWait()
    this.#asked = true
    this.#clock.calmFrame(now => this.#tick(now))
  }

  /** Be called after changes, at most `rate` times a second; the last change is never missed. */
  every(rate: number, act: () => void): () => void {
    const one: Subscriber = { period: 1000 / rate, act, last: Number.NEGATIVE_INFINITY, due: true }
    this.#subscribers.add(one)
    this.wake()
    return () => this.#subscribers.delete(one)
  }

  #tick(now: number): void {
    this.#asked = false
    this.#inside = true
    const seconds = this.#last === null ? 0 : Math.min((now - this.#last) / 1000, LONGEST)
    this.#last = null
    let more = false
    let wait: number | null = null
    try {
      more = this.#advance(seconds)
      if (this.#dirty) {
        this.#dirty = false
        this.#show()
      }
      wait = this.#serve(now)
    } finally {
      // One frame that fails must not stop the clock for good.
      this.#inside = false
    }
    if (more) this.#goOn(now)
    else if (this.#dirty) this.wake()
    else if (wait !== null) this.#cancelWait = this.#clock.after(wait, () => this.wake())
  }

  /** While it plays, frames follow each other. */
  #goOn(now: number): void {
    this.#last = now
    this.#asked = true
    this.#clock.frame(next => this.#tick(next))
  }

  /** Call who is due; return the time [ms] until the next one is, null when nobody waits. */
  #serve(now: number): number | null {
    let wait: number | null = null
    for (const one of this.#subscribers) {
      if (!one.due) continue
      const left = one.last + one.period - now
      // Half a frame early is on time: a 20 Hz listener must not slip to every fourth frame.
      if (left <= 8) {
        one.due = false
        one.last = now
        one.act()
      } else {
        wait = Math.min(wait ?? left, left)
      }
    }
    return wait
  }
}

const browserClock: LoopClock = {
  frame: act => requestAnimationFrame(act),
  calmFrame: act => onNextFrame(act),
  after: (milliseconds, act) => {
    const timer = setTimeout(act, milliseconds)
    return () => clearTimeout(timer)
  },
}
