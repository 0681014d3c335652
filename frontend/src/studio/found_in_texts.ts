/** Findings that came with a run or a scene, each source with the texts that they are of, as problems of the texts of now. */
import type { Finding } from '../run/run'
import type { Problem } from './problems'
import type { RunLines, Texts } from './run_lines'

interface Found {
  readonly findings: readonly Finding[]
  readonly texts: Texts
}

export interface FoundWires {
  readonly lines: RunLines
  readonly documentOf: (source: string) => string
  /** The problems of a source are these from now on. */
  readonly list: (source: string, problems: readonly Problem[]) => void
}

export class FoundInTexts {
  readonly #wires: FoundWires
  readonly #found = new Map<string, Found>()
  /** Documents whose findings the language server reports, at every change of the texts. */
  #checked: ReadonlySet<string> = new Set()

  constructor(wires: FoundWires) {
    this.#wires = wires
  }

  /** The findings of a source are these; they belong to texts of a moment. */
  set(source: string, findings: readonly Finding[], texts: Texts): void {
    const found = { findings, texts }
    this.#found.set(source, found)
    this.#list(source, found)
  }

  /** The language server reports the findings of these documents. */
  setChecked(documents: ReadonlySet<string>): void {
    const isSame =
      documents.size === this.#checked.size && [...documents].every(one => this.#checked.has(one))
    this.#checked = documents
    if (!isSame) this.renew()
  }

  /** Texts have changed: problems move with their lines. */
  renew(): void {
    for (const [source, found] of this.#found) {
      if (found.findings.length > 0 && found.texts.size > 0) this.#list(source, found)
    }
  }

  #list(source: string, found: Found): void {
    this.#wires.list(source, this.#wires.lines.problems(this.#standing(found), found.texts))
  }

  /**
   * What the compiler found in an older text is no more than a memory where the language server answers for the text
   * of now: a run may still take minutes. What a run found is of that run, and stays until the next one is planned.
   */
  #standing({ findings, texts }: Found): readonly Finding[] {
    if (!this.#wires.lines.areChanged(texts)) return findings
    const isAnswered = ({ span }: Finding) =>
      span !== null && this.#checked.has(this.#wires.documentOf(span.source))
    return findings.filter(one => one.stage !== 'compiling' || !isAnswered(one))
  }
}
