/** The page's line to `ropsim studio`: says hello, delivers messages in order, comes back by itself. */
import type { Command } from './commands'
import { type Door, door, enter, REFUSED } from './entry'
import type { Message } from './messages'

/** `expired`: the server refuses this page; only the address that the terminal shows helps. */
export type ConnectionState = 'connecting' | 'connected' | 'lost' | 'expired'

export interface ConnectionListeners {
  readonly onMessage: (message: Message) => void
  readonly onFrame: (bytes: ArrayBuffer) => void
  readonly onState: (state: ConnectionState) => void
}

/** What a connection needs of the browser; tests give their own. */
export interface Surroundings {
  readonly open: (url: string) => WebSocket
  readonly door: Door
  readonly after: (milliseconds: number, act: () => void) => () => void
}

/** Waiting times between attempts [ms]; the last one repeats. */
export const BACK_OFF = [200, 400, 800, 1500, 3000] as const

export class Connection {
  readonly #url: string
  readonly #tab: string
  readonly #listeners: ConnectionListeners
  readonly #around: Surroundings
  #socket: WebSocket | null = null
  #state: ConnectionState = 'connecting'
  #attempts = 0
  #cancelWait: () => void = () => {}
  #closed = false

  constructor(url: string, tab: string, listeners: ConnectionListeners, around: Surroundings = browser) {
    this.#url = url
    this.#tab = tab
    this.#listeners = listeners
    this.#around = around
  }

  get state(): ConnectionState {
    return this.#state
  }

  open(): void {
    this.#closed = false
    this.#cancelWait()
    const socket = this.#around.open(this.#url)
    socket.binaryType = 'arraybuffer'
    this.#socket = socket
    socket.onmessage = event => this.#receive(socket, event.data)
    socket.onclose = ({ code }) => {
      if (this.#socket === socket) this.#lost(code)
    }
  }

  /** Send a command; false when it could not be sent. */
  send(command: Command): boolean {
    if (this.#state !== 'connected' || this.#socket?.readyState !== 1) return false
    this.#socket.send(JSON.stringify(command))
    return true
  }

  close(): void {
    this.#closed = true
    this.#cancelWait()
    this.#socket?.close()
    this.#socket = null
  }

  #receive(socket: WebSocket, data: unknown): void {
    if (data instanceof ArrayBuffer) {
      this.#listeners.onFrame(data)
      return
    }
    const said: unknown = JSON.parse(String(data))
    const entry = enter(socket, said, this.#around.door)
    if (entry === 'in') socket.send(JSON.stringify({ type: 'hello', tab: this.#tab }))
    if (entry !== 'none') return
    const message = said as Message
    if (message.type === 'welcome') {
      this.#attempts = 0
      this.#become('connected')
    }
    this.#listeners.onMessage(message)
  }

  #lost(code: number): void {
    this.#socket = null
    if (this.#closed) return
    const isRefused = code === REFUSED
    this.#become(isRefused ? 'expired' : 'lost')
    // Refused by the studio of another project that has the port now, welcome as soon as the own one is back.
    const last = BACK_OFF.length - 1
    const wait = BACK_OFF[isRefused ? last : Math.min(this.#attempts, last)] ?? 0
    this.#attempts += 1
    this.#cancelWait = this.#around.after(wait, () => this.open())
  }

  #become(state: ConnectionState): void {
    if (state === this.#state) return
    this.#state = state
    this.#listeners.onState(state)
  }
}

const browser: Surroundings = {
  open: url => new WebSocket(url),
  door,
  after: (milliseconds, act) => {
    const timer = setTimeout(act, milliseconds)
    return () => clearTimeout(timer)
  },
}
