/** A parameter that is no point: a number with its unit, a plain number, yes or no. */
import type { FocusEvent } from 'react'
import { oneNumber, splitValue } from '../../studio/chosen_step'
import { taskWords } from '../../text/tasks'
import type { TaskParameter } from '../../wire/messages'
import { FieldLabel } from './FieldLabel'

interface ValueFieldProps {
  readonly parameter: TaskParameter
  readonly value: string
  readonly onValue: (typed: string) => void
  /** What was typed is complete. */
  readonly onDone: () => void
  readonly onLeft: (event: FocusEvent) => void
}

export function ValueField({ parameter, value, onValue, onDone, onLeft }: ValueFieldProps) {
  const { word, kind, units } = parameter
  const label = <FieldLabel word={word} sentence={parameter.sentence} />
  if (kind === 'bool') {
    return (
      <label className="value-field" onBlur={onLeft}>
        {label}
        <select
          aria-label={taskWords.value(word)}
          value={value}
          onChange={event => {
            onValue(event.target.value)
            onDone()
          }}
        >
          <option value="">{taskWords.choosePoint}</option>
          <option value="true">{taskWords.truth.true}</option>
          <option value="false">{taskWords.truth.false}</option>
        </select>
      </label>
    )
  }
  const { number, unit } = splitValue(value)
  const shown = unit || splitValue(parameter.default).unit || units[0] || ''
  const choices = units.length > 0 && !units.includes(shown) ? [shown, ...units] : units
  const compose = (typed: string, chosen: string) => (typed.trim() && chosen ? `${typed} ${chosen}` : typed)
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: that the keyboard leaves its fields bubbles up here
    <div className="value-field" onBlur={onLeft}>
      <label>
        {label}
        <input
          type="text"
          inputMode="decimal"
          aria-label={taskWords.value(word)}
          placeholder={parameter.default}
          value={number}
          onChange={event => {
            const typed = splitValue(event.target.value)
            onValue(compose(oneNumber(typed.number), typed.unit || (choices.length > 0 ? shown : '')))
          }}
          onBlur={onDone}
        />
      </label>
      {choices.length > 0 ? (
        <select
          aria-label={taskWords.unit(word)}
          value={shown}
          onChange={event => {
            onValue(compose(number, event.target.value))
            onDone()
          }}
        >
          {choices.map(one => (
            <option key={one} value={one}>
              {one}
            </option>
          ))}
        </select>
      ) : null}
    </div>
  )
}
