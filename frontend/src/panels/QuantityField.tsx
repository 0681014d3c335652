/** A field for a number with a unit: shows the value, takes `12.5 mm`, `90 deg`, `13*2`. */
import { useId, useState } from 'react'
import { type Dimension, parseQuantity } from '../units/parse'
import { formatQuantity } from '../units/quantity'

interface QuantityFieldProps {
  readonly label: string
  /** [m | rad] */
  readonly value: number
  readonly dimension: Dimension
  readonly disabled?: boolean
  /** Why the value that was typed last was not taken; empty when it was. */
  readonly refused?: string
  readonly onValue: (value: number) => void
}

export function QuantityField({
  label,
  value,
  dimension,
  disabled = false,
  refused = '',
  onValue,
}: QuantityFieldProps) {
  const [typed, setTyped] = useState<string | null>(null)
  const [mistake, setMistake] = useState('')
  const [last, setLast] = useState(value)
  const id = useId()
  const complaint = mistake || (typed === null ? refused : '')
  const shown = formatQuantity(value, dimension === 'length' ? 'm' : 'rad')
  const take = () => {
    if (typed === null) return
    const parsed = parseQuantity(typed, dimension)
    if ('mistake' in parsed) {
      setMistake(parsed.mistake)
      return
    }
    setTyped(null)
    setMistake('')
    onValue(parsed.value)
  }
  const drop = () => {
    setTyped(null)
    setMistake('')
  }
  if (value !== last) {
    setLast(value)
    // Whoever moves the value by other means has given up what was typed wrong.
    if (mistake) drop()
  }
  return (
    <span className="quantity">
      <input
        type="text"
        inputMode="text"
        aria-label={label}
        aria-invalid={complaint !== ''}
        aria-describedby={complaint ? id : undefined}
        disabled={disabled}
        value={typed ?? shown}
        onFocus={event => event.target.select()}
        onChange={event => {
          setTyped(event.target.value)
          setMistake('')
        }}
        onBlur={take}
        onKeyDown={event => {
          if (event.key === 'Enter') take()
          if (event.key === 'Escape') drop()
        }}
      />
      {complaint ? (
        <span className="mistake" id={id} role="alert">
          {complaint}
        </span>
      ) : null}
    </span>
  )
}
