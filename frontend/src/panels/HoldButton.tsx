/** A button that moves once when it is pressed, and on and on while it is held: by pointer or by keyboard. */
import { useEffect, useRef } from 'react'
import { type HeldMove, Hold } from '../studio/hold'

interface HoldButtonProps {
  readonly sign: string
  readonly label: string
  readonly title: string
  readonly disabled: boolean
  readonly start: () => HeldMove
}

export function HoldButton({ sign, label, title, disabled, start }: HoldButtonProps) {
  const held = useRef<Hold | null>(null)
  held.current ??= new Hold()
  const hold = held.current
  useEffect(() => () => hold.release(), [hold])
  useEffect(() => {
    if (disabled) hold.release()
  }, [hold, disabled])
  useEffect(() => {
    // A window that is left hears of no release.
    const leave = () => hold.release()
    addEventListener('blur', leave)
    return () => removeEventListener('blur', leave)
  }, [hold])
  const release = () => hold.release()
  return (
    <button
      type="button"
      className="hold"
      disabled={disabled}
      aria-label={label}
      title={title}
      onPointerDown={event => {
        if (event.button !== 0) return
        event.currentTarget.setPointerCapture(event.pointerId)
        hold.press(start())
      }}
      onPointerUp={release}
      onPointerCancel={release}
      onLostPointerCapture={release}
      onBlur={release}
      onContextMenu={event => {
        // A long touch is a hold here.
        if (hold.held) event.preventDefault()
      }}
      onKeyDown={event => {
        if (event.key === 'Escape' && hold.held) {
          event.stopPropagation()
          hold.release()
        }
        if (event.key !== 'Enter' && event.key !== ' ') return
        event.preventDefault()
        event.stopPropagation()
        if (!event.repeat) hold.press(start())
      }}
      onKeyUp={event => {
        if (event.key !== 'Enter' && event.key !== ' ') return
        event.preventDefault()
        hold.release()
      }}
      onClick={event => {
        // Readers of the screen press without pointer and key.
        if (event.detail !== 0) return
        hold.press(start())
        hold.release()
      }}
    >
      {sign}
    </button>
  )
}
