/** All commands in one searchable list, each with its key. */
import { type KeyboardEvent, useEffect, useId, useRef, useState } from 'react'
import { words } from '../text/messages'
import type { StudioCommand } from './commands'
import { useStudio } from './context'
import { shownKey } from './keys'

export function Palette({ onClose }: { onClose: () => void }) {
  const { commands } = useStudio()
  const [query, setQuery] = useState('')
  const [chosen, setChosen] = useState(0)
  const dialog = useRef<HTMLDialogElement>(null)
  const id = useId()
  const found = commands.search(query)
  const active = found[Math.min(chosen, found.length - 1)]
  useEffect(() => dialog.current?.showModal(), [])
  useEffect(() => {
    if (active) document.getElementById(`${id}${active.id}`)?.scrollIntoView({ block: 'nearest' })
  }, [active, id])
  // The dialog gives the focus back where it was; the command may then take it elsewhere.
  // Its event comes later: a key that opens the next palette may be faster.
  const close = () => {
    dialog.current?.close()
    onClose()
  }
  const run = (command: StudioCommand | undefined) => {
    if (!command || !commands.isEnabled(command)) return
    close()
    commands.run(command.id)
  }
  const keys = (event: KeyboardEvent) => {
    // Enter and arrows choose among the characters that an input method offers.
    if (event.nativeEvent.isComposing) return
    if (event.key === 'ArrowDown') setChosen((chosen + 1) % Math.max(found.length, 1))
    else if (event.key === 'ArrowUp') setChosen((chosen - 1 + found.length) % Math.max(found.length, 1))
    else if (event.key === 'Enter') run(active)
    else return
    event.preventDefault()
  }
  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: a click beside the list closes it, Escape does so by itself
    <dialog
      ref={dialog}
      className="palette"
      aria-label={words.palette.title}
      onClose={onClose}
      onClick={event => (event.target === dialog.current ? close() : undefined)}
    >
      <input
        type="search"
        role="combobox"
        aria-expanded="true"
        aria-controls={`${id}list`}
        aria-activedescendant={active ? `${id}${active.id}` : undefined}
        aria-label={words.palette.search}
        placeholder={words.palette.search}
        value={query}
        onChange={event => {
          setQuery(event.target.value)
          setChosen(0)
        }}
        onKeyDown={keys}
      />
      <div role="listbox" id={`${id}list`} aria-label={words.palette.title}>
        {found.map((one, at) => (
          // biome-ignore lint/a11y/useKeyWithClickEvents: keys are handled by the search field above
          <div
            key={one.id}
            id={`${id}${one.id}`}
            role="option"
            tabIndex={-1}
            aria-selected={one === active}
            aria-disabled={!commands.isEnabled(one)}
            onClick={() => run(one)}
            onPointerMove={() => setChosen(at)}
          >
            <span className="where">{words.menus[one.menu]}</span>
            <span className="title">{one.title}</span>
            {one.keys.map(key => (
              <kbd key={key}>{shownKey(key)}</kbd>
            ))}
          </div>
        ))}
      </div>
      {found.length === 0 ? <p className="quiet">{words.palette.none}</p> : null}
    </dialog>
  )
}
