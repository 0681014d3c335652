/** The line that runs at the cursor and the line shown as a ghost: an arrow in the gutter and a tinted line. */
import { type Extension, RangeSet, StateEffect, StateField, type Text } from '@codemirror/state'
import { Decoration, type DecorationSet, EditorView, GutterMarker, gutter } from '@codemirror/view'
import { words } from './words'

export interface MarkedLines {
  readonly running: number | null
  readonly ghost: number | null
}

class Arrow extends GutterMarker {
  constructor(
    readonly sign: string,
    readonly title: string,
    readonly name: string,
  ) {
    super()
  }

  override eq(other: Arrow): boolean {
    return other.name === this.name
  }

  override toDOM(): Node {
    const element = document.createElement('span')
    element.className = `cm-arrow-${this.name}`
    element.title = this.title
    element.textContent = this.sign
    return element
  }
}

const RUNNING = new Arrow('▶', words.running, 'running')
const GHOST = new Arrow('◇', words.ghost, 'ghost')
const RUNNING_LINE = Decoration.line({ class: 'cm-running' })
const GHOST_LINE = Decoration.line({ class: 'cm-ghost' })

const setMarks = StateEffect.define<MarkedLines>()

interface Shown {
  readonly marks: MarkedLines
  readonly lines: DecorationSet
  readonly arrows: RangeSet<GutterMarker>
}

const NONE: MarkedLines = { running: null, ghost: null }

function shown(doc: Text, marks: MarkedLines): Shown {
  const lines = []
  const arrows = []
  for (const [number, line, arrow] of [
    [marks.ghost, GHOST_LINE, GHOST],
    [marks.running, RUNNING_LINE, RUNNING],
  ] as const) {
    if (number === null || number < 1 || number > doc.lines) continue
    const { from } = doc.line(number)
    lines.push(line.range(from))
    arrows.push(arrow.range(from))
  }
  return { marks, lines: Decoration.set(lines, true), arrows: RangeSet.of<GutterMarker>(arrows, true) }
}

const field = StateField.define<Shown>({
  create: state => shown(state.doc, NONE),
  update: (value, transaction) => {
    for (const effect of transaction.effects) {
      if (effect.is(setMarks)) return shown(transaction.newDoc, effect.value)
    }
    if (!transaction.docChanged) return value
    // Lines move with the text above them until the next run says where they are.
    const { changes } = transaction
    return { ...value, lines: value.lines.map(changes), arrows: value.arrows.map(changes) }
  },
  provide: self => EditorView.decorations.from(self, value => value.lines),
})

/** Show marks in a view; does nothing where they are shown already. */
export function showMarks(view: EditorView, marks: MarkedLines): void {
  const { running, ghost } = view.state.field(field).marks
  if (running === marks.running && ghost === marks.ghost) return
  view.dispatch({ effects: setMarks.of(marks) })
}

export function lineMarks(): Extension {
  return [field, gutter({ class: 'cm-arrows', markers: view => view.state.field(field).arrows })]
}
