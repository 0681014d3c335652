/** Findings of all sources, and what the user is told once. */
import { mergeProblems, type Problem } from './problems'
import type { StudioStore } from './state'

export class Noticeboard {
  readonly #store: StudioStore
  readonly #problems = new Map<string, readonly Problem[]>()
  #id = 0

  constructor(store: StudioStore) {
    this.#store = store
  }

  setProblems(source: string, problems: readonly Problem[]): void {
    this.#problems.set(source, problems)
    this.#store.setState({ problems: mergeProblems(this.#problems) })
  }

  /** Tell the user something; the same words are not told twice at once. */
  notify(level: 'error' | 'warning' | 'info', text: string, hint: string, code: string): void {
    const id = ++this.#id
    const notice = { type: 'notice', level, code, text, hint, id } as const
    const others = this.#store.getState().notices.filter(one => one.text !== text)
    this.#store.setState({ notices: [...others.slice(-4), notice] })
  }

  dismiss(id: number): void {
    this.#store.setState({ notices: this.#store.getState().notices.filter(one => one.id !== id) })
  }
}
