/** What runs have found, as marks on the lines of a text. */
import type { Diagnostic } from '@codemirror/lint'
import type { Text } from '@codemirror/state'
import type { EditorView } from '@codemirror/view'
import { grouped, type ProblemGroup } from '../studio/problem_groups'
import type { Problem } from '../studio/problems'
import { marksShown, putMarks } from './shown_marks'
import { words } from './words'

/** Tells marks of runs from those of the language server. */
const MARK = 'cm-found'

export function foundMarks(problems: readonly Problem[], doc: Text): readonly Diagnostic[] {
  return grouped(problems).flatMap(group => {
    const { line, column, endLine, endColumn, severity, code } = group.first
    if (line < 1 || line > doc.lines) return []
    const at = doc.line(line)
    const text = at.text.trim()
    const start = at.from + at.text.indexOf(text)
    // A finding of a whole line is under its words.
    const whole = endLine === line && endColumn <= column
    const from = whole ? start : Math.min(at.from + Math.max(column - 1, 0), at.to)
    const end = doc.line(Math.min(Math.max(endLine, line), doc.lines))
    const to = whole ? start + text.length : Math.min(end.from + Math.max(endColumn - 1, 0), end.to)
    return [
      { from, to: Math.max(to, from), severity, message: messageOf(group), source: code, markClass: MARK },
    ]
  })
}

function messageOf({ first, all }: ProblemGroup): string {
  const count = all.length > 1 ? [words.times(all.length)] : []
  return [first.message, ...(first.hint ? [first.hint] : []), ...count].join('\n')
}

/** Show these marks of runs beside the marks of the language server that the view has. */
export function showFound(view: EditorView, problems: readonly Problem[]): void {
  const others = marksShown(view.state, mark => mark.markClass !== MARK)
  putMarks(view, [...others, ...foundMarks(problems, view.state.doc)])
}
