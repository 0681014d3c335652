/** Lines of a program and the robot: which line runs, and where the robot stood after a line. */
import type { Run } from '../run/run'
import { nearestPass, type Pass, passesOf } from './passes'
import type { Picture } from './picture'
import type { GhostLine, StudioStore } from './state'

export interface LineWires {
  readonly run: () => Run | null
  readonly time: () => number
  readonly documentOf: (source: string) => string
  readonly mark: () => void
}

export class LineGhost {
  readonly #store: StudioStore
  readonly #picture: Picture
  readonly #wires: LineWires

  constructor(store: StudioStore, picture: Picture, wires: LineWires) {
    this.#store = store
    this.#picture = picture
    this.#wires = wires
  }

  passes(document: string, line: number): readonly Pass[] {
    const run = this.#wires.run()
    return run ? passesOf(run, source => this.#wires.documentOf(source) === document, line) : []
  }

  /** Draw the robot where a line had done its work; pass from 1, else the one nearest to the cursor. */
  show(document: string, line: number, pass?: number): void {
    const passes = this.passes(document, line)
    const index = pass === undefined ? nearestPass(passes, this.#wires.time()) : pass - 1
    const chosen = passes[index]
    this.#set(chosen ? { document, line, pass: index + 1, passes: passes.length, time: chosen.to } : null)
  }

  clear(): void {
    if (this.#store.getState().ghost) this.#set(null)
  }

  /** Another run is shown: the same pass of the same line in it. */
  renew(): void {
    const { ghost } = this.#store.getState()
    if (ghost) this.show(ghost.document, ghost.line, ghost.pass)
  }

  /** The line that runs at the cursor, null where none does. */
  running(): { readonly document: string; readonly line: number } | null {
    const run = this.#wires.run()
    const line = run ? Math.round(run.value('line', 0, this.#wires.time())) : 0
    return run && line > 0 ? { document: this.#wires.documentOf(run.source), line } : null
  }

  #set(ghost: GhostLine | null): void {
    this.#store.setState({ ghost })
    this.#picture.ghost(ghost?.time ?? null)
    this.#wires.mark()
  }
}
