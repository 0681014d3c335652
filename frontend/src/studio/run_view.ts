/** Run, cursor and picture kept together: a new run keeps the view, a live run may be followed. */
import type { Run } from '../run/run'
import type { Transport } from '../run/transport'
import type { Loop } from './loop'
import type { Picture } from './picture'
import type { StudioStore } from './state'

export class RunView {
  readonly #store: StudioStore
  readonly #transport: Transport
  readonly #picture: Picture
  readonly #loop: Loop
  /** The cursor is being moved by the run, not by the user. */
  #own = false

  constructor(store: StudioStore, transport: Transport, picture: Picture, loop: Loop) {
    this.#store = store
    this.#transport = transport
    this.#picture = picture
    this.#loop = loop
    transport.cursor.onTime(() => this.#moved())
    transport.cursor.onChange(() => loop.wake())
  }

  /** Show another run: cameras stay, the cursor stays at its time, playing goes on. */
  show(run: Run): void {
    const { shown, status } = this.#store.getState()
    this.#own = true
    this.#transport.cursor.setEnd(run.duration)
    this.#own = false
    this.#transport.show(run)
    this.#picture.setRun(run)
    // A page that is opened while the text has errors gets the last good run after it has heard of them.
    const isOld = !run.live && (status?.state === 'refused' || status?.state === 'failed')
    this.setStale(isOld ? 'stale' : 'current')
    this.#store.setState({ shown: shown + 1, following: run.live })
    this.#loop.mark()
  }

  /** The live run has grown. */
  grown(run: Run): void {
    this.#own = true
    const { cursor } = this.#transport
    cursor.setEnd(run.duration)
    if (this.#store.getState().following) cursor.seek(run.duration)
    this.#own = false
    this.#loop.mark()
  }

  /** Whether the text has changed since the run that is shown. */
  setStale(now: 'stale' | 'current'): void {
    const stale = now === 'stale'
    if (stale === this.#store.getState().stale) return
    this.#store.setState({ stale })
    this.#picture.stale(stale)
    this.#loop.mark()
  }

  #moved(): void {
    // The user scrubs back in a live run: stay there.
    if (!this.#own && this.#store.getState().following) this.#store.setState({ following: false })
    this.#loop.mark()
  }
}
