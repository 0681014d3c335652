/** A point: a location or a list of points by its name, typed numbers, or the jogged pose. */
import { type ClipboardEvent, type FocusEvent, useState } from 'react'
import { isName, joinNumbers, splitNumbers } from '../../studio/chosen_step'
import { useStudio } from '../../studio/context'
import { useChanges } from '../../studio/hooks'
import { pastedNumbers } from '../../studio/pasted_numbers'
import { taskWords } from '../../text/tasks'
import { FieldLabel } from './FieldLabel'

interface PointFieldProps {
  /** What people call it. */
  readonly parameter: string
  readonly sentence?: string
  /** The list before it that gives it; empty for none. */
  readonly listed?: string
  readonly value: string
  readonly onValue: (typed: string) => void
  /** What was typed is complete. */
  readonly onDone: () => void
}

interface PointFieldsProps extends PointFieldProps {
  readonly onLeft: (event: FocusEvent) => void
}

/** The choice that opens fields for numbers; no point has this text. */
const NUMBERS = '#'

export function PointField({
  parameter,
  sentence = '',
  listed = '',
  value,
  onValue,
  onDone,
  onLeft,
}: PointFieldsProps) {
  const { jog, tasks } = useStudio()
  useChanges(jog)
  const [typing, setTyping] = useState(false)
  const places = tasks.list?.places ?? []
  const known = places.some(one => one.text === value)
  const isTyped = value !== '' && !known && !isName(value)
  const byNumbers = isTyped || (typing && !known && value === '')
  const frames = places.filter(one => one.frame)
  const lists = [...new Set(places.filter(one => one.list).map(one => one.list))]
  const jogged = jog.q ? (jog.answer?.typed ?? '') : ''
  const choose = (text: string) => {
    setTyping(text === NUMBERS)
    onValue(text === NUMBERS ? (isTyped ? value : '') : text)
    onDone()
  }
  // Numbers of another program or a row of a sheet fill all fields, wherever in the point they are pasted.
  const paste = (event: ClipboardEvent) => {
    const numbers = pastedNumbers(event.clipboardData.getData('text'))
    if (numbers.length === 0) return
    event.preventDefault()
    setTyping(true)
    onValue(joinNumbers(numbers))
    onDone()
  }
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: what is pasted into a field of it bubbles up here
    <div className="point-field" onPaste={paste} onBlur={onLeft}>
      <label>
        <FieldLabel word={parameter} sentence={sentence} />
        <select
          aria-label={taskWords.point(parameter)}
          value={byNumbers ? NUMBERS : value}
          onChange={event => choose(event.target.value)}
        >
          <option value="">{listed ? taskWords.fromList(listed) : taskWords.choosePoint}</option>
          {value !== '' && !known && isName(value) ? (
            <option value={value}>{taskWords.gone(value)}</option>
          ) : null}
          <optgroup label={taskWords.locations}>
            {places
              .filter(one => !one.list && !one.frame)
              .map(one => (
                <option key={one.name} value={one.text}>
                  {one.name}
                </option>
              ))}
          </optgroup>
          {frames.length > 0 ? (
            <optgroup label={taskWords.frames}>
              {frames.map(one => (
                <option key={one.name} value={one.text}>
                  {taskWords.origin(one.name)}
                </option>
              ))}
            </optgroup>
          ) : null}
          {lists.map(list => (
            <optgroup key={list} label={list}>
              {places
                .filter(one => one.list === list)
                .map(one => (
                  <option key={one.name} value={one.text}>
                    {one.name || taskWords.wholeList(list, one.count)}
                  </option>
                ))}
            </optgroup>
          ))}
          <option value={NUMBERS}>{taskWords.numbers}</option>
        </select>
      </label>
      <button
        type="button"
        className="take"
        disabled={!jogged}
        title={jogged ? taskWords.joggedHint : taskWords.notJogged}
        onClick={() => choose(jogged)}
      >
        {taskWords.jogged}
      </button>
      {byNumbers ? (
        <NumberFields parameter={parameter} value={value} onValue={onValue} onDone={onDone} />
      ) : null}
    </div>
  )
}

function NumberFields({ parameter, value, onValue, onDone }: PointFieldProps) {
  const numbers = splitNumbers(value)
  return (
    <div className="number-fields">
      {taskWords.axes.map((axis, k) => (
        <label key={axis}>
          {axis}
          <input
            type="text"
            inputMode="decimal"
            aria-label={`${parameter} ${axis} [${taskWords.axisUnits[k]}]`}
            placeholder={taskWords.axisUnits[k]}
            value={numbers[k] ?? ''}
            onChange={event =>
              onValue(joinNumbers(numbers.map((one, at) => (at === k ? event.target.value : one))))
            }
            onBlur={onDone}
          />
        </label>
      ))}
    </div>
  )
}
