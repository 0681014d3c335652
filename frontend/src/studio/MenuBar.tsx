/** The menus; every entry is a command of the registry. */
import { type KeyboardEvent, useEffect, useRef, useState } from 'react'
import { words } from '../text/messages'
import { MENUS, type Menu, type StudioCommand } from './commands'
import { useStudio } from './context'
import { useChanges } from './hooks'
import { shownKey } from './keys'
import { usePopover } from './use_popover'

export function MenuBar() {
  const studio = useStudio()
  const [open, setOpen] = useState<Menu | null>(null)
  const bar = useRef<HTMLDivElement>(null)
  useChanges(studio.undo)
  usePopover(bar, open !== null, () => setOpen(null))
  useEffect(() => {
    if (open) bar.current?.querySelector<HTMLElement>('.menu [role^=menuitem]')?.focus()
  }, [open])

  const move = (from: Menu, step: 1 | -1) => {
    const next = MENUS[(MENUS.indexOf(from) + step + MENUS.length) % MENUS.length] ?? 'File'
    bar.current?.querySelector<HTMLElement>(`[data-menu=${next}]`)?.focus()
    if (open) setOpen(next)
  }
  const close = (menu: Menu) => {
    setOpen(null)
    bar.current?.querySelector<HTMLElement>(`[data-menu=${menu}]`)?.focus()
  }
  const keys = (event: KeyboardEvent, menu: Menu) => {
    if (event.key === 'ArrowRight') move(menu, 1)
    else if (event.key === 'ArrowLeft') move(menu, -1)
    else if (event.key === 'Tab') {
      setOpen(null)
      return
    } else if (open && (event.key === 'ArrowDown' || event.key === 'ArrowUp')) walk(event)
    else if (event.key === 'ArrowDown') setOpen(menu)
    else return
    event.preventDefault()
    event.stopPropagation()
  }
  return (
    <div className="menubar" role="menubar" aria-label={words.product} ref={bar}>
      {MENUS.map((menu, at) => (
        <div key={menu} className="menu-place" onKeyDown={event => keys(event, menu)} role="none">
          <button
            type="button"
            role="menuitem"
            data-menu={menu}
            aria-haspopup="menu"
            aria-expanded={open === menu}
            tabIndex={at === 0 ? 0 : -1}
            onClick={() => setOpen(open === menu ? null : menu)}
            onPointerEnter={() => (open ? setOpen(menu) : undefined)}
          >
            {words.menus[menu]}
          </button>
          {open === menu ? <MenuList menu={menu} onDone={() => close(menu)} /> : null}
        </div>
      ))}
    </div>
  )
}

function MenuList({ menu, onDone }: { menu: Menu; onDone: () => void }) {
  const { commands, undo } = useStudio()
  const own = commands.all.filter(one => one.menu === menu)
  const groups = [...new Set(own.map(one => one.group))]
  const choose = (command: StudioCommand) => {
    onDone()
    commands.run(command.id)
  }
  const title = (command: StudioCommand) => {
    if (command.id === 'edit.undo') return words.undo(undo.next)
    return command.id === 'edit.redo' ? words.redo(undo.nextRedo) : command.title
  }
  return (
    <div className={groups.length > 5 ? 'menu wide' : 'menu'} role="menu" aria-label={words.menus[menu]}>
      {groups.map((group, at) => (
        // biome-ignore lint/a11y/useSemanticElements: a group of menu items is no fieldset
        <div key={group} role="group" className={at > 0 ? 'menu-group ruled' : 'menu-group'}>
          {own
            .filter(one => one.group === group)
            .map(one => (
              <button
                key={one.id}
                type="button"
                {...(one.checked
                  ? { role: 'menuitemcheckbox', 'aria-checked': one.checked() }
                  : { role: 'menuitem' })}
                aria-disabled={!commands.isEnabled(one)}
                onClick={() => choose(one)}
              >
                <span className="tick" aria-hidden="true">
                  {one.checked?.() ? '✓' : ''}
                </span>
                <span className="title">{title(one)}</span>
                {one.keys[0] ? <kbd>{shownKey(one.keys[0])}</kbd> : null}
              </button>
            ))}
        </div>
      ))}
    </div>
  )
}

/** Up and down inside an open menu. */
function walk(event: KeyboardEvent): void {
  const items = [...event.currentTarget.querySelectorAll<HTMLElement>('.menu [role^=menuitem]')]
  const at = items.findIndex(one => one.contains(document.activeElement))
  const step = event.key === 'ArrowDown' ? 1 : -1
  items[(at + step + items.length) % items.length]?.focus()
}
