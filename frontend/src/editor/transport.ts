/** The way to the language server over a web socket that may break: it comes back by itself. */
import type { Transport } from '@codemirror/lsp-client'
import { enter } from '../wire/entry'

export interface LinkEvents {
  /** A connection stands; it serves until `onLost`. */
  readonly onReady: (transport: Transport) => void
  readonly onLost: () => void
}

/** Waits before the tries to come back [ms]; the last one repeats. */
const WAITS = [250, 500, 1000, 2000, 5000] as const

/** Of an answer to what was asked of an older text: the editor asks again, nobody need be told. */
const CONTENT_MODIFIED = -32801

export class LanguageLink {
  readonly #address: string
  readonly #events: LinkEvents
  #socket: WebSocket | null = null
  #timer: ReturnType<typeof setTimeout> | undefined
  #tries = 0
  #isClosed = false

  constructor(address: string, events: LinkEvents) {
    this.#address = address
    this.#events = events
  }

  open(): void {
    const socket = new WebSocket(this.#address)
    const listeners = new Set<(message: string) => void>()
    const unanswered = new Set<number | string>()
    const tell = (message: string) => {
      for (const listener of listeners) listener(message)
    }
    let isReady = false
    this.#socket = socket
    const ready = () => {
      isReady = true
      this.#tries = 0
      this.#events.onReady({
        send: message => {
          if (socket.readyState !== WebSocket.OPEN) return
          const id = requestId(message)
          if (id !== null) unanswered.add(id)
          socket.send(message)
        },
        subscribe: listener => listeners.add(listener),
        unsubscribe: listener => listeners.delete(listener),
      })
    }
    socket.onmessage = event => {
      if (typeof event.data !== 'string') return
      if (!isReady) {
        if (enter(socket, JSON.parse(event.data)) === 'in') ready()
        return
      }
      const { id, isOvertaken } = answerOf(event.data)
      if (id !== null) unanswered.delete(id)
      tell(isOvertaken ? nothing(id) : event.data)
    }
    socket.onclose = () => {
      // Whoever waits for an answer is told that there is none, so that no promise stays open or fails.
      for (const id of unanswered) tell(nothing(id))
      if (isReady) this.#events.onLost()
      if (!this.#isClosed) this.#again()
    }
  }

  close(): void {
    this.#isClosed = true
    clearTimeout(this.#timer)
    this.#socket?.close()
  }

  #again(): void {
    const wait = WAITS[Math.min(this.#tries, WAITS.length - 1)] ?? 5000
    this.#tries += 1
    this.#timer = setTimeout(() => this.open(), wait)
  }
}

/** Of a request that can be answered by nothing; the client would look into the answer to `initialize`. */
function requestId(message: string): number | string | null {
  const { id, method } = JSON.parse(message) as { id?: number | string; method?: string }
  return id !== undefined && method !== undefined && method !== 'initialize' ? id : null
}

/** The request that a message answers, null for none, and whether the text was changed before that was worked out. */
function answerOf(message: string): { id: number | string | null; isOvertaken: boolean } {
  const { id, method, error } = JSON.parse(message) as {
    id?: number | string | null
    method?: string
    error?: { code: number }
  }
  if (method !== undefined) return { id: null, isOvertaken: false }
  return { id: id ?? null, isOvertaken: error?.code === CONTENT_MODIFIED }
}

/** The answer that there is nothing to tell. */
function nothing(id: number | string | null): string {
  return JSON.stringify({ jsonrpc: '2.0', id, result: null })
}
