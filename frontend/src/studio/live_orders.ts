/** Orders to the live run. Play and pause hold it and let it go on, and leave the cursor alone. */
import type { Player, Transport } from '../run/transport'
import type { Command } from '../wire/commands'
import type { LiveStatus } from '../wire/messages'
import type { StudioStore } from './state'

export type LiveOrder = 'hold' | 'continue' | 'step' | 'stop'

type State = LiveStatus['state']

/** How a run stands right after an order. The end of a step, and of the run, it reports on its own. */
const AFTER = { hold: 'held', continue: 'running', step: 'running' } as const

export class LiveOrders implements Player {
  readonly #store: StudioStore
  readonly #send: (command: Command) => boolean
  /** What the orders lead to that the run has not answered yet, the oldest first. */
  #unanswered: readonly State[] = []

  constructor(store: StudioStore, send: (command: Command) => boolean) {
    this.#store = store
    this.#send = send
  }

  /** How the run stands when it has obeyed all orders; null where there is none. */
  get state(): State | null {
    return this.#unanswered.at(-1) ?? this.#store.getState().live?.state ?? null
  }

  get playing(): boolean {
    return this.state === 'running'
  }

  /** Send an order; false where it means nothing in the state that the orders before lead to. */
  order(order: LiveOrder): boolean {
    const { state } = this
    if (state === null || state === 'over') return false
    if (order !== 'stop' && (state === 'starting' || state === AFTER[order])) return false
    const isSent = this.#send({ type: 'live_control', action: order })
    if (isSent && order !== 'stop') this.#unanswered = [...this.#unanswered, AFTER[order]]
    return isSent
  }

  toggle(): void {
    this.order(this.playing ? 'hold' : 'continue')
  }

  /** Nobody answers the orders that were on their way. */
  forget(): void {
    this.#unanswered = []
  }

  /** The run tells how it stands: it answers orders one by one, and speaks of other things in between. */
  hear(live: LiveStatus | null): void {
    if (!live || live.state === 'starting' || live.state === 'over') this.forget()
    else if (live.state === this.#unanswered[0]) this.#unanswered = this.#unanswered.slice(1)
  }
}

/** Let the transport drive the live run as long as one is under way; return what gives it orders. */
export function driveLiveRuns(
  store: StudioStore,
  transport: Transport,
  send: (command: Command) => boolean,
): LiveOrders {
  const orders = new LiveOrders(store, send)
  store.subscribe(({ live, connection }, before) => {
    if (connection !== before.connection) orders.forget()
    if (live === before.live) return
    orders.hear(live)
    transport.drive(live && live.state !== 'over' ? orders : null)
  })
  return orders
}
