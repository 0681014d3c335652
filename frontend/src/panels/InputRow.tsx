/** One input: its value, the key that sets it, how, and a button that does the same. */
import { useEffect, useState } from 'react'
import type { SignalDescription } from '../scene/description'
import { useStudio, useStudioState } from '../studio/context'
import { KEY_MODES, type KeyMode } from '../studio/key_sensors'
import { words } from '../text/messages'
import { formatPlain } from '../units/quantity'
import { keyLabel } from './key_label'

export function InputRow({ signal, value }: { signal: SignalDescription; value: number }) {
  const { signals } = useStudio()
  const live = useStudioState(state => state.live !== null && state.live.state !== 'over')
  const [learning, setLearning] = useState(false)
  const { name } = signal
  const binding = signals.bindings.find(one => one.signal === name)
  useEffect(() => {
    if (!learning) return
    const learn = (event: KeyboardEvent) => {
      // Tab leads on, here as everywhere: bound, it would lock the keyboard in while keys are armed.
      if (event.key === 'Tab') return
      event.preventDefault()
      event.stopPropagation()
      setLearning(false)
      if (event.code === 'Escape') return
      const code = event.code === 'Delete' || event.code === 'Backspace' ? '' : event.code
      signals.rebind(name, { code }, words.signals.bound(name, keyLabel(code)))
    }
    addEventListener('keydown', learn, { capture: true })
    return () => removeEventListener('keydown', learn, { capture: true })
  }, [learning, name, signals])
  const on = value !== signal.initial
  return (
    <div className={on ? 'input-row on' : 'input-row'}>
      <span className="name" title={name}>
        {name}
      </span>
      <output>{formatPlain(value)}</output>
      <button
        type="button"
        aria-label={words.signals.change(name)}
        aria-pressed={learning}
        onClick={() => setLearning(!learning)}
        onBlur={() => setLearning(false)}
      >
        {learning ? (
          words.signals.learn
        ) : (
          <kbd>{binding?.code ? keyLabel(binding.code) : words.signals.noKey}</kbd>
        )}
      </button>
      <select
        aria-label={words.signals.modeOf(name)}
        value={binding?.mode ?? 'hold'}
        onChange={event =>
          signals.rebind(name, { mode: event.target.value as KeyMode }, words.signals.moded(name))
        }
      >
        {KEY_MODES.map(mode => (
          <option key={mode} value={mode}>
            {words.signals.modes[mode]}
          </option>
        ))}
      </select>
      <button
        type="button"
        className="set"
        aria-label={words.signals.button(name)}
        disabled={!live}
        onPointerDown={() => signals.press(name)}
        onPointerUp={() => signals.release(name)}
        onPointerLeave={() => signals.release(name)}
        onKeyDown={event => {
          if (!event.repeat && (event.key === ' ' || event.key === 'Enter')) signals.press(name)
        }}
        onKeyUp={() => signals.release(name)}
        onBlur={() => signals.release(name)}
      >
        {words.signals.press}
      </button>
    </div>
  )
}
