/** Whatever arrives between the keys, in whatever order, the text is what was typed and what others wrote. */
import { EditorState, type Text, type TransactionSpec } from '@codemirror/state'
import type { EditorView } from '@codemirror/view'
import { expect, test } from 'vitest'
import { Documents } from '../studio/documents'
import type { DocumentState } from '../wire/messages'
import { External, takenOver } from './external'
import { marksOf } from './findings'
import type { Edit } from './places'
import { decorations } from './same_name'
import { changesIn } from './server_edits'
import { putMarks } from './shown_marks'
import { task } from './task_language'
import { lastTaught, taughtMove } from './taught_move'
import { dice, pressed } from './typist'

/** Interleavings in each run of the tests; `TYPED=5000` tries more. */
const MANY = Number(process.env.TYPED ?? 200)
const NAME = 'programs/main.task'
const URI = 'file:///p/main.task'
/** The line that is typed at begins so. */
const MINE = '# mine: '
const START = `program t\nunits mm, deg, s\nn = alpha \nmov alpha\n${MINE}\nlin alpha \nopen\nclose\nstop\n`
const TYPED = 'const n = (3) * "that"'

/** The studio's server with the file of the text, as another program may write it. */
class Server {
  text = START
  disk = START
  base = START
  version = 0

  get unsaved(): boolean {
    return this.text !== this.disk
  }

  state(text: string | null): DocumentState {
    const { version, base, unsaved, conflict } = this
    return {
      name: NAME,
      uri: URI,
      language: 'task',
      text,
      version,
      base,
      unsaved,
      conflict,
      recovered: false,
    }
  }

  get conflict(): boolean {
    return this.unsaved && this.base !== this.disk
  }

  edit(text: string, version: number, base: string | null): void {
    Object.assign(this, { text, version, base: text === this.disk ? this.disk : (base ?? this.base) })
  }

  /** Write the file, over another one if the user has been asked. */
  save(disk: 'keep' | 'overwrite'): void {
    if (!this.conflict || disk === 'overwrite') Object.assign(this, { disk: this.text, base: this.text })
  }

  /** Another program writes the file. */
  meet(disk: string): void {
    if (this.unsaved) Object.assign(this, { disk, base: this.text === disk ? disk : this.base })
    else Object.assign(this, { disk, text: disk, base: disk, version: 0 })
  }
}

/** The text that a plain list of lines would be: each of the acts on lines, without any editor. */
class Lines {
  constructor(public text: string) {}

  change(line: (line: string) => string): void {
    this.text = this.text.split('\n').map(line).join('\n')
  }

  type(key: string): void {
    this.change(line => (line.startsWith(MINE) ? line + key : line))
  }
}

const formatted = (line: string) => line.trimEnd()
const renamed = (name: string) => (line: string) => line.replace('alpha', name)

/** The edits that change whole lines of a text. */
function lineEdits(doc: Text, change: (line: string) => string): Edit[] {
  return doc
    .toString()
    .split('\n')
    .flatMap((text, line) => {
      const end = { line, character: text.length }
      const newText = text.startsWith(MINE) ? text : change(text)
      return newText === text ? [] : [{ range: { start: { line, character: 0 }, end }, newText }]
    })
}

/** The page: its documents and an editor whose view is its state. */
class Page {
  readonly documents = new Documents()
  readonly lines = new Lines(START)
  /** How many texts of the file were taken over. */
  taken = 0
  state = EditorState.create({ doc: START, extensions: [task(), lastTaught] })
  #revision = 0

  constructor(readonly server: Server) {
    this.documents.welcome([server.state(server.text)])
    this.toMine()
  }

  dispatch(spec: TransactionSpec): void {
    const transaction = this.state.update(spec)
    this.state = transaction.state
    if (transaction.docChanged && !transaction.annotation(External)) this.#changed()
  }

  type(key: string): void {
    this.state = pressed(this.state, key)
    this.#changed()
    this.lines.type(key)
  }

  teach(): void {
    const before = this.state
    const words = new Set(before.doc.toString().match(/\w+/g))
    this.dispatch(taughtMove(before, '(1, 2, 3)', words))
    this.lines.text = this.state.doc.toString()
    expect(this.lines.text.split('\n').filter(line => !/^(?:loc|mov) p\d/.test(line))).toEqual(
      before.doc
        .toString()
        .split('\n')
        .filter(line => !/^(?:loc|mov) p\d/.test(line)),
    )
    this.toMine()
  }

  receive(state: DocumentState): void {
    this.documents.update([state])
    const revision = this.documents.shown[0]?.revision ?? 0
    if (revision === this.#revision) return
    this.#revision = revision
    const text = this.documents.text(NAME)
    expect(mine(text)).toBe(mine(this.lines.text)) // a text without what was typed is not taken
    const change = takenOver(this.state.doc, text)
    if (change) this.dispatch(change)
    this.lines.text = text
    this.taken += 1
  }

  /** Put the cursor behind the line that is typed at. */
  toMine(): void {
    const text = this.state.doc.toString()
    const begin = text.indexOf(MINE)
    this.dispatch({ selection: { anchor: this.state.doc.lineAt(begin).to } })
  }

  #changed(): void {
    this.documents.edit(NAME, this.state.doc.toString())
  }
}

function mine(text: string): string {
  return text.split('\n').find(line => line.startsWith(MINE)) ?? 'gone'
}

/** Type with answers of both servers and writers of the file in between; how often a text of the file was taken over. */
function interleaved(seed: number): number {
  const roll = dice(seed)
  const server = new Server()
  const page = new Page(server)
  const lines: { toServer: (() => void)[]; toPage: (() => void)[]; language: (() => void)[] } = {
    toServer: [],
    toPage: [],
    language: [],
  }
  const ways = Object.values(lines)
  const deliver = (way: (() => void)[]) => way.shift()?.()
  const tell = (text: string | null) => {
    const state = server.state(text)
    lines.toPage.push(() => page.receive(state))
  }
  const send = () => {
    for (const edit of page.documents.unsent()) {
      page.documents.sent(NAME, edit.version)
      lines.toServer.push(() => {
        server.edit(edit.text, edit.version, edit.base)
        tell(null)
      })
    }
  }
  const ask = (change: (line: string) => string) => {
    const asked = page.state.doc
    const edits = lineEdits(asked, change)
    lines.language.push(() => {
      const now = page.state.doc
      const made = changesIn({ [URI]: edits }, new Map([[URI, asked]]), new Map([[URI, now]]))
      expect(made !== null).toBe(now.eq(asked))
      if (!made) return
      for (const changes of made.values()) page.dispatch({ changes })
      page.lines.change(line => (line.startsWith(MINE) ? line : change(line)))
    })
  }
  const mark = () => {
    const asked = page.state.doc
    const end = { line: asked.lines - 1, character: 0 }
    const range = { start: { line: roll(asked.lines), character: 0 }, end }
    lines.language.push(() => {
      if (page.state.doc !== asked) return
      putMarks(
        page as unknown as EditorView,
        marksOf([{ range, message: 'no' }], asked, at => at),
      )
      decorations(page.state.doc, [{ range }])
    })
  }
  const save = (disk: 'keep' | 'overwrite') => {
    send()
    lines.toServer.push(() => {
      server.save(disk)
      tell(server.text)
    })
  }
  const meet = () => {
    const number = roll(1000)
    server.meet(
      server.disk
        .split('\n')
        .flatMap(line => {
          if (line.startsWith(MINE) || roll(4)) return [line]
          return [[line, `n = ${number}`], [`${line.trimEnd()} # ${number}`], [`wait ${number} s`, line]][
            roll(3)
          ]
        })
        .join('\n'),
    )
    tell(server.text)
  }
  const settle = () => {
    send()
    while (ways.some(way => way.length > 0)) for (const way of ways) deliver(way)
  }
  const acts = [
    () => ask(formatted),
    () => ask(renamed(`beta${roll(100)}`)),
    mark,
    mark,
    meet,
    () => roll(3) || page.teach(),
    () => save('keep'),
    () => save('overwrite'),
  ]
  for (let typed = 0; typed < TYPED.length; ) {
    if (roll(2)) page.type(TYPED[typed++] ?? '')
    for (let count = roll(4); count > 0; count -= 1) acts[roll(acts.length)]?.()
    if (roll(2)) send()
    for (let count = roll(5); count > 0; count -= 1) deliver(ways[roll(3)] ?? [])
    if (roll(3) === 0) settle()
    expect(page.state.doc.toString(), `seed ${seed}`).toBe(page.lines.text)
  }
  settle()
  settle()
  const text = page.state.doc.toString()
  expect(text, `seed ${seed}`).toBe(page.lines.text)
  expect(mine(text), `seed ${seed}`).toBe(MINE + TYPED)
  expect(page.documents.text(NAME), `seed ${seed}`).toBe(text)
  expect(server.text, `seed ${seed}`).toBe(text)
  return page.taken
}

test('the text is what was typed and what others wrote, in all orders of answers', () => {
  let taken = 0
  for (let seed = 0; seed < MANY; seed += 1) taken += interleaved(seed)
  expect(taken).toBeGreaterThan(MANY / 2)
}, 3_600_000)
