/** A veil over the canvas, a message over everything, and text for those who do not see the picture. */
import type { Words } from './words'

let count = 0

export class Overlay {
  readonly #veil = document.createElement('div')
  readonly #message = document.createElement('div')
  readonly #text = document.createElement('p')
  readonly #spoken = document.createElement('p')
  readonly #keys = document.createElement('p')

  constructor(host: HTMLElement, words: Words) {
    count += 1
    this.#veil.className = 'stage-veil'
    this.#message.className = 'stage-message'
    this.#message.setAttribute('role', 'status')
    this.#message.append(this.#text)
    this.#spoken.className = 'stage-spoken'
    this.#spoken.id = `stage-spoken-${count}`
    this.#keys.className = 'stage-spoken'
    this.#keys.id = `stage-keys-${count}`
    this.#keys.textContent = words.keys
    this.stale(false)
    this.message(null)
    host.append(this.#veil, this.#message, this.#spoken, this.#keys)
  }

  /** Ids of the texts that describe every viewport. */
  get describedBy(): string {
    return `${this.#spoken.id} ${this.#keys.id}`
  }

  stale(on: boolean): void {
    this.#veil.hidden = !on
  }

  /** Cover everything with a text, or nothing. */
  message(text: string | null): void {
    this.#message.hidden = text === null
    this.#text.textContent = text ?? ''
  }

  describe(text: string): void {
    if (this.#spoken.textContent !== text) this.#spoken.textContent = text
  }

  remove(): void {
    for (const element of [this.#veil, this.#message, this.#spoken, this.#keys]) element.remove()
  }
}
