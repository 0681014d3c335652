/** Several fields of one kind: facts, conditions. */
import { useId } from 'react'
import { useStudio } from '../../studio/context'
import { formWords as words } from '../../text/task_form'
import { Faults } from './Faults'

interface FormLinesProps {
  readonly title: string
  readonly hint?: string
  /** The property that they belong to. */
  readonly field: string
  readonly lines: readonly string[]
  readonly suggestions: readonly string[]
  readonly onLines: (lines: readonly string[]) => void
}

export function FormLines({ title, hint = '', field, lines, suggestions, onLines }: FormLinesProps) {
  const { forms } = useStudio()
  const list = useId()
  return (
    <fieldset>
      <legend>{title}</legend>
      {hint ? <p className="quiet">{hint}</p> : null}
      {lines.map((line, place) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: a line is known by its place alone, what it says is typed
        <div key={place} className="form-line">
          <input
            type="text"
            className="code"
            list={list}
            spellCheck={false}
            aria-label={`${title} ${place + 1}`}
            value={line}
            onChange={event => onLines(lines.map((one, at) => (at === place ? event.target.value : one)))}
          />
          <button
            type="button"
            aria-label={words.removeLine(`${title} ${place + 1}`)}
            title={words.removeLine(line)}
            onClick={() => onLines(lines.filter((_, at) => at !== place))}
          >
            ✕
          </button>
        </div>
      ))}
      <Faults faults={forms.faults([field])} />
      <button type="button" onClick={() => onLines([...lines, ''])}>
        {words.add}
      </button>
      <datalist id={list}>
        {suggestions.map(one => (
          <option key={one} value={one} />
        ))}
      </datalist>
    </fieldset>
  )
}
