/** Beside each line that moves: whether its simulated result is that of the text as it stands. */
import { type Extension, RangeSet, StateEffect, StateField } from '@codemirror/state'
import { type EditorView, GutterMarker, gutter } from '@codemirror/view'
import { type LineResult, type LineResults, NO_RESULTS } from '../studio/line_results'
import { resultWords } from '../text/line_results'

class Mark extends GutterMarker {
  constructor(readonly result: LineResult) {
    super()
  }

  override eq(other: Mark): boolean {
    return other.result === this.result
  }

  override toDOM(): Node {
    const element = document.createElement('span')
    element.className = `cm-result-${this.result}`
    element.title = resultWords[this.result]
    return element
  }
}

const MARKS: Readonly<Record<LineResult, Mark>> = {
  valid: new Mark('valid'),
  pending: new Mark('pending'),
  stale: new Mark('stale'),
}

const setResults = StateEffect.define<LineResults>()

interface Shown {
  readonly results: LineResults
  readonly marks: RangeSet<GutterMarker>
}

const field = StateField.define<Shown>({
  create: () => ({ results: NO_RESULTS, marks: RangeSet.empty }),
  update: (value, { effects, docChanged, changes, newDoc }) => {
    for (const effect of effects) {
      if (!effect.is(setResults)) continue
      const lines = [...effect.value].filter(([line]) => line >= 1 && line <= newDoc.lines)
      const marks = lines.map(([line, result]) => MARKS[result].range(newDoc.line(line).from))
      return { results: effect.value, marks: RangeSet.of<GutterMarker>(marks, true) }
    }
    // Marks move with the text until the language server has looked at it.
    return docChanged ? { ...value, marks: value.marks.map(changes) } : value
  },
})

/** Show results of lines in a view; does nothing where they are shown already. */
export function showResults(view: EditorView, results: LineResults): void {
  const { results: before } = view.state.field(field)
  if (results === before) return
  view.dispatch({ effects: setResults.of(results) })
}

export function resultMarks(): Extension {
  return [field, gutter({ class: 'cm-results', markers: view => view.state.field(field).marks })]
}
