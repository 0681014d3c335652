/** Press and hold: one step at once, then on and on, ever faster up to a limit, until it is let go. */

/** Wait before the first repetition [ms]; a shorter press is one step. */
export const DELAY = 350
/** Time between two movements [ms]. */
export const PERIOD = 50
/** Time after which the greatest rate is reached [s]. */
const RAMP = 2
/** Longest time that one movement makes up for [s]: a page that slept does not leap. */
const LONGEST = 0.15

export interface HeldMove {
  /** The step of a single press. */
  readonly step: number
  /** Greatest rate, per second, of the same quantity. */
  readonly fastest: number
  /** Move by an amount; false where it goes no further. */
  readonly move: (amount: number) => boolean
  /** The last movement is still on its way. */
  readonly busy: () => boolean
  readonly end: () => void
}

export interface HoldClock {
  readonly now: () => number
  readonly every: (milliseconds: number, act: () => void) => () => void
}

export class Hold {
  readonly #clock: HoldClock
  #move: HeldMove | null = null
  #stop: () => void = () => {}
  #begun = 0
  #last = 0

  constructor(clock: HoldClock = browserClock) {
    this.#clock = clock
  }

  get held(): boolean {
    return this.#move !== null
  }

  press(move: HeldMove): void {
    this.release()
    this.#move = move
    this.#begun = this.#clock.now() + DELAY
    this.#last = this.#begun
    this.#stop = this.#clock.every(PERIOD, () => this.#tick())
    if (!move.move(move.step)) this.release()
  }

  release(): void {
    const move = this.#move
    if (!move) return
    this.#move = null
    this.#stop()
    move.end()
  }

  #tick(): void {
    const move = this.#move
    const now = this.#clock.now()
    if (!move || now < this.#begun || move.busy()) return
    const seconds = Math.min((now - this.#last) / 1000, LONGEST)
    this.#last = now
    if (seconds > 0 && !move.move(rate(move, (now - this.#begun) / 1000) * seconds)) this.release()
  }
}

/** From two steps a second, or the limit where that is less, up to the limit. */
function rate({ step, fastest }: HeldMove, seconds: number): number {
  const slowest = Math.min(2 * step, fastest)
  return slowest + (fastest - slowest) * Math.min(seconds / RAMP, 1) ** 2
}

const browserClock: HoldClock = {
  now: () => performance.now(),
  every: (milliseconds, act) => {
    const timer = setInterval(act, milliseconds)
    return () => clearInterval(timer)
  },
}
