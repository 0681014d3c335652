/** Sends typed text to the server: soon, newest only, and again when the connection is back. */
import type { Command } from '../wire/commands'
import type { Documents } from './documents'

/** Keystrokes within this time go as one [ms]. */
export const DELAY = 50

export class Outbox {
  readonly #documents: Documents
  readonly #send: (command: Command) => boolean
  #timer: ReturnType<typeof setTimeout> | null = null

  constructor(documents: Documents, send: (command: Command) => boolean) {
    this.#documents = documents
    this.#send = send
  }

  soon(): void {
    this.#timer ??= setTimeout(() => this.flush(), DELAY)
  }

  flush(): void {
    if (this.#timer) clearTimeout(this.#timer)
    this.#timer = null
    for (const edit of this.#documents.unsent()) {
      if (this.#send(edit)) this.#documents.sent(edit.document, edit.version)
    }
  }
}
