/** The texts of the project in this page: what was typed, what the server has, what must still be sent. */
import type { Edit } from '../wire/commands'
import type { DocumentState, DocumentsChanged } from '../wire/messages'
import { TextHistory } from './text_history'

/** A document as the page shows it. For the newest text ask `Documents.text`. */
export interface StudioDocument extends Omit<DocumentState, 'text' | 'version' | 'base'> {
  /** Counts the times the text was replaced from outside (file, other tab, form); an editor then takes it over. */
  readonly revision: number
}

interface Entry {
  shown: StudioDocument
  text: string
  /** Counts the edits of this tab. */
  version: number
  /** Names the content of the file on which the text was written. */
  base: string
  /** The newest edit that was put on the line; 0 for none on this connection. */
  sentVersion: number
  /** The newest edit of this tab has not been taken by the server yet. */
  pending: boolean
  /** The text was typed here and neither saved nor given up since. */
  typed: boolean
}

export class Documents {
  /** Texts as the server has, or had them. */
  readonly history = new TextHistory()
  readonly #entries = new Map<string, Entry>()
  #shown: readonly StudioDocument[] = []

  /** The same array until a name, a mark or a revision changes. */
  get shown(): readonly StudioDocument[] {
    return this.#shown
  }

  text(name: string): string {
    return this.#entries.get(name)?.text ?? ''
  }

  has(name: string): boolean {
    return this.#entries.has(name)
  }

  /** Take all documents of a (new) connection; text typed here that the server lacks is kept and pending. */
  welcome(states: readonly DocumentState[]): void {
    const names = new Set(states.map(state => state.name))
    for (const [name, entry] of this.#entries) {
      if (!names.has(name) && !entry.typed) this.#entries.delete(name)
    }
    for (const state of states) {
      const entry = this.#entries.get(state.name)
      if (entry?.typed && entry.text !== state.text) {
        entry.pending = true
        entry.sentVersion = 0
        entry.shown = { ...stateOf(state, entry.shown.revision), unsaved: true }
      } else {
        this.#adopt(state, state.text ?? '')
        const adopted = this.#entries.get(state.name)
        if (adopted) adopted.pending = false
      }
    }
    this.#changed()
  }

  /** Take states that the server announces; a text is newer than ours unless ours is still on its way. */
  update(states: DocumentsChanged['documents']): void {
    for (const state of states) {
      const entry = this.#entries.get(state.name)
      if (!entry) {
        this.#adopt(state, state.text ?? '')
        continue
      }
      if (state.version >= entry.version) entry.pending = false
      // A text that comes from the file (version 0) is not the one on which ours was written.
      if (!entry.pending || state.version > 0) entry.base = state.base
      if (state.text !== null && !entry.pending) this.#adopt(state, state.text)
      else entry.shown = stateOf(state, entry.shown.revision)
      if (!state.unsaved && !entry.pending) entry.typed = false
    }
    this.#changed()
  }

  /** New text from the keyboard. */
  edit(name: string, text: string): void {
    const entry = this.#entries.get(name)
    if (!entry || entry.text === text) return
    entry.text = text
    entry.version += 1
    entry.pending = true
    entry.typed = true
    if (!entry.shown.unsaved) {
      entry.shown = { ...entry.shown, unsaved: true }
      this.#changed()
    }
  }

  /** New text from elsewhere in this page than the keyboard, such as a form: an editor takes it over. */
  write(name: string, text: string): void {
    const entry = this.#entries.get(name)
    if (!entry || entry.text === text) return
    this.edit(name, text)
    entry.shown = { ...entry.shown, revision: entry.shown.revision + 1 }
    this.#changed()
  }

  /** Edits that are still to be put on the line. */
  unsent(): readonly Edit[] {
    return this.pending().filter(one => this.#entries.get(one.document)?.sentVersion !== one.version)
  }

  sent(name: string, version: number): void {
    const entry = this.#entries.get(name)
    if (!entry) return
    entry.sentVersion = version
    this.history.remember(name, version, entry.text)
  }

  /** Edits that the server has not confirmed: the newest text of each document. */
  pending(): readonly Edit[] {
    return [...this.#entries]
      .filter(([, entry]) => entry.pending)
      .map(([name, entry]) => ({
        type: 'edit',
        document: name,
        text: entry.text,
        version: entry.version,
        base: entry.base,
      }))
  }

  #adopt(state: Omit<DocumentState, 'text'>, text: string): void {
    const entry = this.#entries.get(state.name)
    const replaced = entry !== undefined && entry.text !== text
    this.history.remember(state.name, state.version, text)
    this.#entries.set(state.name, {
      shown: stateOf(state, (entry?.shown.revision ?? 0) + (replaced ? 1 : 0)),
      text,
      sentVersion: 0,
      version: Math.max(entry?.version ?? 0, state.version),
      base: state.base,
      pending: false,
      typed: (entry?.typed ?? false) && !replaced && state.unsaved,
    })
  }

  #changed(): void {
    const next = [...this.#entries.values()].map(entry => entry.shown)
    const same = next.length === this.#shown.length && next.every((one, at) => equal(one, this.#shown[at]))
    if (!same) this.#shown = next
  }
}

function stateOf(state: Omit<DocumentState, 'text'>, revision: number): StudioDocument {
  const { name, uri, language, unsaved, conflict, recovered } = state
  return { name, uri, language, unsaved, conflict, recovered, revision }
}

function equal(a: StudioDocument, b: StudioDocument | undefined): boolean {
  return b !== undefined && (Object.keys(a) as (keyof StudioDocument)[]).every(key => a[key] === b[key])
}
