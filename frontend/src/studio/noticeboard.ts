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
    const found = this.#found(this.#store.getState().found)
    this.#store.setState({ problems: mergeProblems(this.#problems), found })
  }

  /** What runs and scenes have found and the language server does not say; the same array until it changes. */
  #found(before: readonly Problem[]): readonly Problem[] {
    const place = (one: Problem) => [one.document, one.line, one.code].join('|')
    const known = new Set(this.#problems.get('lsp')?.map(place))
    const others = new Map([...this.#problems].filter(([source]) => source !== 'lsp'))
    const found = mergeProblems(others).filter(one => !known.has(place(one)))
    const same = found.length === before.length && found.every((one, at) => equal(one, before[at]))
    return same ? before : found
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

function equal(a: Problem, b: Problem | undefined): boolean {
  return b !== undefined && (Object.keys(a) as (keyof Problem)[]).every(key => a[key] === b[key])
}
