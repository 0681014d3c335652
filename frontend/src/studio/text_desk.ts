/** The texts on the desk: typing, saving, giving up, and where the editor is asked to go. */
import { words } from '../text/messages'
import type { Command } from '../wire/commands'
import { documentOfSource } from './document_names'
import { Documents } from './documents'
import type { EditEntry } from './edit_table'
import { Outbox } from './outbox'
import type { StudioStore } from './state'

/** A place in a text that the editor is asked to show; line and column from 1. */
export interface Place {
  readonly document: string
  readonly line: number
  readonly column: number
}

/** Takes a change of the text back, or makes it again; false where another text stands there by now. */
export interface WayBack {
  /** Whether it still is to be undone: an editor has its own way back, too. */
  readonly stands: () => boolean
  readonly undo: () => boolean
  readonly redo: () => boolean
}

/** Writes a location into a text; a name that it needs is none of those taken, which are in small letters. */
type Pen = (text: string, taken: ReadonlySet<string>) => WayBack | null

export class TextDesk {
  readonly documents = new Documents()
  readonly #store: StudioStore
  readonly #send: (command: Command) => boolean
  readonly #warn: (text: string) => void
  readonly #outbox: Outbox
  #wanted = ''
  #made: () => void = () => {}
  readonly #places = new Set<(place: Place) => void>()
  readonly #pens = new Set<Pen>()
  /** Names of points in tables of the project. */
  #points: readonly string[] = []
  readonly #hands = new Set<(entry: EditEntry) => void>()
  /** What is to be done as soon as an editor is there. */
  #awaited: EditEntry | null = null

  constructor(store: StudioStore, send: (command: Command) => boolean, warn: (text: string) => void) {
    this.#store = store
    this.#send = send
    this.#warn = warn
    this.#outbox = new Outbox(this.documents, send)
  }

  /** Whether the server has every text. */
  get delivered(): boolean {
    return this.documents.pending().length === 0
  }

  /** All texts as they are now. */
  now(): ReadonlyMap<string, string> {
    return new Map(this.documents.shown.map(({ name }) => [name, this.documents.text(name)]))
  }

  /** Text that an editor has. */
  edit(document: string, text: string): void {
    this.documents.edit(document, text)
    this.#changed()
  }

  /** Text that an editor of the document is to take over. */
  write(document: string, text: string): void {
    this.documents.write(document, text)
    this.#changed()
  }

  #changed(): void {
    this.sync()
    if (this.#store.getState().editing) this.#outbox.soon()
  }

  /** Send what has not been sent, now. A tab without the right to edit keeps it. */
  flush(): void {
    if (this.#store.getState().editing) this.#outbox.flush()
  }

  save(document: string, disk: 'keep' | 'overwrite'): void {
    this.flush()
    const sent = this.#send({ type: 'save', document, overwrite: disk === 'overwrite' })
    if (!sent) this.#warn(words.documents.notSaved)
  }

  /** Make a new text and show it as soon as it is there; `made` is called then. Points of a program go with it. */
  create(document: string, text: string, made: () => void = () => {}, points = ''): void {
    this.flush()
    this.#made = made
    this.#wanted = this.#send({ type: 'create', document, text, points }) ? document : ''
    if (!this.#wanted) this.#warn(words.documents.notSaved)
  }

  /** Show the program that was made, if it is there by now. */
  showWanted(): void {
    if (!this.documents.has(this.#wanted)) return
    this.#store.setState({ document: this.#wanted })
    this.#wanted = ''
    this.#made()
  }

  /** Let the panels know of new names and marks. */
  sync(): void {
    const { shown } = this.documents
    const state = this.#store.getState()
    if (shown === state.documents) return
    const known = shown.some(one => one.name === state.document)
    this.#store.setState({ documents: shown, document: known ? state.document : (shown[0]?.name ?? '') })
  }

  /** Name of the document that a span's source means, empty where there is none. */
  documentOf(source: string): string {
    return documentOfSource(source, this.documents.shown)
  }

  goTo(place: Place): void {
    if (!this.documents.has(place.document)) return
    this.#store.setState({ document: place.document })
    for (const listener of this.#places) listener(place)
  }

  onGoTo(listener: (place: Place) => void): () => void {
    this.#places.add(listener)
    return () => this.#places.delete(listener)
  }

  /** Have a location written where the cursor of the editor is; the way back, null where no editor takes it. */
  teach(text: string): WayBack | null {
    let back: WayBack | null = null
    for (const pen of this.#pens) back = pen(text, this.#words()) ?? back
    return back
  }

  setPoints(names: readonly string[]): void {
    this.#points = names
  }

  /** All words of texts and tables of points: names of programs, cell and tasks are among them. */
  #words(): ReadonlySet<string> {
    const found = [...this.now().values(), ...this.#points].flatMap(
      text => text.toLowerCase().match(/[a-z_]\w*/g) ?? [],
    )
    return new Set(found)
  }

  /** Have something done in the editor; false where none is open: the next one does it. */
  act(entry: EditEntry): boolean {
    this.#awaited = this.#hands.size > 0 ? null : entry
    for (const hand of this.#hands) hand(entry)
    return this.#awaited === null
  }

  onAct(hand: (entry: EditEntry) => void): () => void {
    this.#hands.add(hand)
    const awaited = this.#awaited
    this.#awaited = null
    if (awaited) hand(awaited)
    return () => this.#hands.delete(hand)
  }

  onTeach(pen: Pen): () => void {
    this.#pens.add(pen)
    return () => this.#pens.delete(pen)
  }
}
