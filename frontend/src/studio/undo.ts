/** One list of what was done, each with the way back. Text has the editor's own history. */

export interface Step {
  /** What was done, in words: "Move joint 3". */
  readonly name: string
  /** False once it was undone in another way; it is passed over then. Always true where it is left out. */
  readonly stands?: () => boolean
  readonly undo: () => void
  readonly redo: () => void
}

/** Steps beyond this number are forgotten, oldest first. */
const LONGEST = 200

export class UndoStack {
  #done: Step[] = []
  #undone: Step[] = []
  /** The next step as listeners know it. */
  #said: string | null = null
  readonly #listeners = new Set<() => void>()

  /** Names of what can be undone, newest first. */
  get names(): readonly string[] {
    return this.#done
      .filter(isStanding)
      .map(step => step.name)
      .reverse()
  }

  get next(): string | null {
    return this.#done.filter(isStanding).at(-1)?.name ?? null
  }

  get nextRedo(): string | null {
    return this.#undone.at(-1)?.name ?? null
  }

  onChange(listener: () => void): () => void {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  /** Do a step and keep the way back. */
  do(step: Step): void {
    step.redo()
    this.did(step)
  }

  /** Keep a step that has already happened. */
  did(step: Step): void {
    this.#done = [...this.#done.slice(1 - LONGEST), step]
    this.#undone = []
    this.#changed()
  }

  undo(): void {
    const step = this.#done.filter(isStanding).at(-1)
    if (!step) return
    this.#done = this.#done.slice(0, this.#done.lastIndexOf(step))
    step.undo()
    this.#undone.push(step)
    this.#changed()
  }

  redo(): void {
    const step = this.#undone.pop()
    if (!step) return
    step.redo()
    this.#done.push(step)
    this.#changed()
  }

  /** Something was done or undone elsewhere: say so if another step is the next one now. */
  look(): void {
    if (this.next !== this.#said) this.#changed()
  }

  #changed(): void {
    this.#said = this.next
    for (const listener of this.#listeners) listener()
  }
}

function isStanding(step: Step): boolean {
  return step.stands?.() ?? true
}
