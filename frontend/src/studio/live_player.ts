/** Play and pause while there is a live run: they hold it and let it go on, and leave the cursor alone. */
import type { Player, Transport } from '../run/transport'
import type { Command } from '../wire/commands'
import type { StudioStore } from './state'

class LivePlayer implements Player {
  readonly #store: StudioStore
  readonly #send: (command: Command) => boolean

  constructor(store: StudioStore, send: (command: Command) => boolean) {
    this.#store = store
    this.#send = send
  }

  get playing(): boolean {
    return this.#store.getState().live?.state === 'running'
  }

  toggle(): void {
    const state = this.#store.getState().live?.state
    if (state !== 'running' && state !== 'held') return
    this.#send({ type: 'live_control', action: state === 'running' ? 'hold' : 'continue' })
  }
}

/** Let the transport drive the live run as long as one is under way. */
export function driveLiveRuns(
  store: StudioStore,
  transport: Transport,
  send: (command: Command) => boolean,
): void {
  const player = new LivePlayer(store, send)
  store.subscribe(({ live }, before) => {
    if (live !== before.live) transport.drive(live && live.state !== 'over' ? player : null)
  })
}
