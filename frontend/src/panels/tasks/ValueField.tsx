/** A parameter that is no point: a number with its unit, a plain number, yes or no. */
import { oneNumber, splitValue } from '../../studio/chosen_step'
import { taskWords } from '../../text/tasks'
import type { TaskParameter } from '../../wire/messages'
import { kindWords } from './kind_words'

interface ValueFieldProps {
  readonly parameter: TaskParameter
  readonly value: string
  readonly onValue: (typed: string) => void
  /** What was typed is complete. */
  readonly onDone: () => void
}

export function ValueField({ parameter, value, onValue, onDone }: ValueFieldProps) {
  const { name, kind, units } = parameter
  const label = taskWords.parameter(name, kindWords(kind))
  if (kind === 'bool') {
    return (
      <label className="value-field">
        <span className="label">{label}</span>
        <select
          aria-label={taskWords.value(name)}
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
    <div className="value-field">
      <label>
        <span className="label">{label}</span>
        <input
          type="text"
          inputMode="decimal"
          aria-label={taskWords.value(name)}
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
          aria-label={taskWords.unit(name)}
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
