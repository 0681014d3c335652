/** Lines of a program and the robot: which line runs, and where the robot stood after a line. */
import type { Run } from '../run/run'
import { channelOf } from '../run/station'
import { nearestPass, type Pass, passesOf } from './passes'
import type { Picture } from './picture'
import type { RunLines } from './run_lines'
import type { GhostLine, StudioStore } from './state'

export interface LineWires {
  readonly run: () => Run | null
  readonly time: () => number
  readonly documentOf: (source: string) => string
  readonly text: (document: string) => string
  readonly lines: RunLines
  readonly mark: () => void
}

interface Wanted {
  readonly document: string
  readonly line: number
  readonly pass: number | undefined
  /** Text in which that is the line. */
  readonly text: string
}

export class LineGhost {
  readonly #store: StudioStore
  readonly #picture: Picture
  readonly #wires: LineWires
  /** Line of the ghost as the run counts it. */
  #line = 0
  /** What was asked for last: a run that is not here yet may have it. */
  #wanted: Wanted | null = null

  constructor(store: StudioStore, picture: Picture, wires: LineWires) {
    this.#store = store
    this.#picture = picture
    this.#wires = wires
  }

  passes(document: string, line: number): readonly Pass[] {
    const run = this.#wires.run()
    const there = this.#wires.lines.toRun(document, line)
    if (!run || there === null) return []
    return passesOf(run, source => this.#wires.documentOf(source) === document, there)
  }

  /** Draw the robot where a line had done its work; pass from 1, else the one nearest to the cursor. */
  show(document: string, line: number, pass?: number): void {
    this.#wanted = { document, line, pass, text: this.#wires.text(document) }
    const passes = this.passes(document, line)
    const index = pass === undefined ? nearestPass(passes, this.#wires.time()) : pass - 1
    const chosen = passes[index]
    this.#line = this.#wires.lines.toRun(document, line) ?? 0
    this.#set(chosen ? { document, line, pass: index + 1, passes: passes.length, time: chosen.to } : null)
  }

  /** Draw the robot where it was at a time [s] at which a line was at work: in that pass. */
  showAt(document: string, line: number, time: number): void {
    const passes = this.passes(document, line)
    const pass = nearestPass(passes, time) + 1
    this.#wanted = { document, line, pass: pass || undefined, text: this.#wires.text(document) }
    this.#line = this.#wires.lines.toRun(document, line) ?? 0
    this.#set(pass > 0 ? { document, line, pass, passes: passes.length, time } : null)
  }

  clear(): void {
    this.#wanted = null
    if (this.#store.getState().ghost) this.#set(null)
  }

  /** Another run is shown: the same pass of the same line in it. */
  renew(): void {
    const wanted = this.#store.getState().ghost ?? this.#waiting()
    if (wanted) this.show(wanted.document, wanted.line, wanted.pass)
  }

  /** The text was edited: the ghost stays with its line. */
  moved(): void {
    const { ghost } = this.#store.getState()
    if (!ghost) return
    const line = this.#wires.lines.toText(ghost.document, this.#line)
    if (line === null) this.clear()
    else if (line !== ghost.line) this.#store.setState({ ghost: { ...ghost, line } })
  }

  /** The lines that run at the cursor, at most one of each station. */
  running(): readonly { readonly document: string; readonly line: number }[] {
    const run = this.#wires.run()
    return (run?.stations ?? []).flatMap(({ name, source }) => {
      // A live run that has only begun has no line yet: its value is NaN.
      const there = Math.round(run?.value(channelOf('line', name), 0, this.#wires.time()) ?? 0)
      if (!(there > 0)) return []
      const document = this.#wires.documentOf(source)
      const line = this.#wires.lines.toText(document, there)
      return line === null ? [] : [{ document, line }]
    })
  }

  /** The line that was asked for before there was a run of it, as long as its text stands. */
  #waiting(): Wanted | null {
    const wanted = this.#wanted
    return wanted && wanted.text === this.#wires.text(wanted.document) ? wanted : null
  }

  #set(ghost: GhostLine | null): void {
    this.#store.setState({ ghost })
    this.#picture.ghost(ghost?.time ?? null)
    this.#wires.mark()
  }
}
