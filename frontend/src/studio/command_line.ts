/** The command line: what is typed, what was told and answered, and the run of all commands. */
import { commandLineWords as words } from '../text/command_line'
import type { Command } from '../wire/commands'
import type { CommandLineState, LineAnswered, ToldLine, WordsOffered } from '../wire/messages'
import { CommandHistory } from './command_history'
import type { UndoStack } from './undo'

export interface CommandLineWires {
  readonly send: (command: Command) => boolean
  /** Show the run of all commands and play it from where the motion of the last one begins [s]. */
  readonly show: (run: number, since: number) => void
  /** Keep what was typed. */
  readonly keep: (lines: readonly string[]) => void
  readonly trouble: (text: string) => void
  /** Nothing more is to be said. */
  readonly leave: () => void
  readonly undo: UndoStack
}

export class CommandLine {
  readonly #wires: CommandLineWires
  readonly #listeners = new Set<() => void>()
  #history = new CommandHistory(null)
  #lines: readonly ToldLine[] = []
  #commands = 0
  /** What the number of commands will be when all that was sent is answered. */
  #expected = 0
  #isOpen = false
  #typed = ''
  #block = ''
  #offered: readonly string[] = []
  #chosen = -1
  #asked = 0
  #numbers = 0
  readonly #sent = new Map<number, string>()
  /** A command that is being done again: its way back is there already. */
  #redone: string | null = null

  constructor(wires: CommandLineWires) {
    this.#wires = wires
  }

  /** What was told, with the answers. */
  get lines(): readonly ToldLine[] {
    return this.#lines
  }

  /** How many commands the robot has carried out that were not taken back. */
  get commands(): number {
    return this.#commands
  }

  get typed(): string {
    return this.#typed
  }

  /** Lines of a block that is not closed yet; empty for none. */
  get block(): string {
    return this.#block
  }

  get busy(): boolean {
    return this.#sent.size > 0
  }

  /** What can end the line, and which of it is chosen; -1 for none. */
  get offered(): readonly string[] {
    return this.#offered
  }

  get chosen(): number {
    return this.#chosen
  }

  onChange(listener: () => void): () => void {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  /** The panel is there: the server tells what was told so far. */
  open(history: unknown): void {
    if (this.#isOpen) return
    this.#isOpen = true
    this.#history = new CommandHistory(history)
    this.#wires.send({ type: 'open_command_line' })
  }

  /** The connection is there again: what was on its way may be lost. */
  reconnected(): void {
    this.#sent.clear()
    if (this.#isOpen) this.#wires.send({ type: 'open_command_line' })
    this.#changed()
  }

  type(text: string): void {
    this.#typed = text
    this.#offer([])
  }

  /** The older line of the history, or the word above in the list. */
  up(): void {
    if (this.#offered.length > 0) this.#choose(-1)
    else this.#recall(this.#history.older(this.#typed))
  }

  down(): void {
    if (this.#offered.length > 0) this.#choose(1)
    else this.#recall(this.#history.newer())
  }

  /** Ask what can stand here; the answer ends the word, or lists what can. False where nothing is typed. */
  complete(): boolean {
    if (!this.#typed.trim()) return false
    if (this.#offered.length > 0) {
      this.#choose(1)
      return true
    }
    this.#asked = ++this.#numbers
    const line = this.#block ? `${this.#block}\n${this.#typed}` : this.#typed
    return this.#wires.send({ type: 'complete_line', id: this.#asked, line })
  }

  /** Take a word of the list. */
  take(word: string): void {
    const begun = /[A-Za-z0-9_]*$/.exec(this.#typed)?.[0] ?? ''
    this.#typed = this.#typed.slice(0, this.#typed.length - begun.length) + word
    this.#offer([])
  }

  /** Say what is typed, or take the word that is chosen. */
  enter(): void {
    const word = this.#offered[this.#chosen]
    if (word !== undefined) {
      this.take(word)
      return
    }
    const line = this.#block ? `${this.#block}\n${this.#typed}` : this.#typed
    if (!line.trim()) return
    if (!this.tell(line)) return
    this.#history.add(this.#typed)
    this.#wires.keep(this.#history.lines)
    this.#typed = ''
    this.#block = ''
    this.#offer([])
  }

  /** Say a line; false where it could not be sent. */
  tell(line: string): boolean {
    const id = ++this.#numbers
    if (!this.#wires.send({ type: 'tell_robot', id, line })) {
      this.#wires.trouble(words.notSent)
      return false
    }
    this.#sent.set(id, line)
    this.#changed()
    return true
  }

  /** Close the list, else give up what is being carried out, else the block, else what is typed. */
  escape(): void {
    if (this.#offered.length > 0) this.#offer([])
    else if (this.busy) this.giveUp()
    else if (this.#block) this.#block = ''
    else this.#typed = ''
    this.#changed()
  }

  /** Give up what is being carried out; the robot is as before. */
  giveUp(): void {
    this.#wires.send({ type: 'give_up_line' })
  }

  receiveState({ lines, commands }: CommandLineState): void {
    this.#lines = lines
    this.#count(commands)
  }

  receiveWords({ id, begun, words: offered }: WordsOffered): void {
    if (id !== this.#asked || !this.#typed.endsWith(begun)) return
    const common = commonStart(offered)
    if (common.length > begun.length) this.take(common)
    else this.#typed = this.#typed.slice(0, this.#typed.length - common.length) + common
    this.#offer(offered.length > 1 ? offered : [])
  }

  receive({ id, line, commands }: LineAnswered): void {
    this.#sent.delete(id)
    if (line.outcome === 'open') {
      this.#block = line.line
      this.#changed()
      return
    }
    this.#lines = [...this.#lines, line]
    if (id > 0 && commands === this.#commands + 1) this.#keepWayBack(line.line, commands)
    this.#count(commands)
    if (line.run > 0) this.#wires.show(line.run, line.since)
    if (id > 0 && line.outcome === 'over') this.#wires.leave()
  }

  /** The step back takes the command back, as long as it is the last one. */
  #keepWayBack(line: string, after: number): void {
    if (this.#redone === line) {
      this.#redone = null
      return
    }
    this.#wires.undo.did({
      name: words.told(line),
      undo: () => {
        if (this.#expected === after && this.tell('undo')) this.#expected = after - 1
      },
      redo: () => {
        if (this.#expected !== after - 1 || !this.tell(line)) return
        this.#expected = after
        this.#redone = line
      },
    })
  }

  #count(commands: number): void {
    this.#commands = commands
    if (!this.busy) this.#expected = commands
    this.#changed()
  }

  #recall(line: string | null): void {
    if (line !== null) this.#typed = line
    this.#changed()
  }

  #choose(step: number): void {
    const count = this.#offered.length
    this.#chosen = (Math.max(this.#chosen, step > 0 ? -1 : 0) + step + count) % count
    this.#changed()
  }

  #offer(offered: readonly string[]): void {
    this.#offered = offered
    this.#chosen = -1
    this.#changed()
  }

  #changed(): void {
    for (const listener of this.#listeners) listener()
  }
}

/** What all words begin with; empty for none. Small and large letters are the same, as the first word has them. */
export function commonStart(all: readonly string[]): string {
  let common = all[0] ?? ''
  for (const word of all) {
    let length = 0
    while (length < common.length && common[length]?.toLowerCase() === word[length]?.toLowerCase()) length++
    common = common.slice(0, length)
  }
  return common
}
