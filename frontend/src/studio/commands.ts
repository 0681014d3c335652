/** Everything a user can do, once: menus, palette and keys read this list. */
import { actsWhileTyping, isTyping, KEPT_BY_BROWSER, keyName, takesPlainKey } from './keys'

export const MENUS = ['File', 'Edit', 'View', 'Simulate', 'Help'] as const
export type Menu = (typeof MENUS)[number]

export interface StudioCommand {
  /** Stable name, such as `file.save`. */
  readonly id: string
  readonly title: string
  readonly menu: Menu
  /** Commands of one group stand together in the menu. */
  readonly group: string
  readonly keys: readonly string[]
  readonly run: () => void
  /** False while it cannot be done; absent for always. */
  readonly enabled?: () => boolean
  /** State of a switch; absent for plain commands. */
  readonly checked?: () => boolean
  /** The text field keeps this key for itself (undo, redo). */
  readonly textKeeps?: true
}

export class Commands {
  readonly #commands = new Map<string, StudioCommand>()
  readonly #keys = new Map<string, string>()

  get all(): readonly StudioCommand[] {
    return [...this.#commands.values()]
  }

  /** Keys that act while text is typed; a text field must leave them alone. */
  get keysOverText(): ReadonlySet<string> {
    return new Set(this.all.filter(one => !one.textKeeps).flatMap(one => one.keys.filter(actsWhileTyping)))
  }

  /** Add a command; returns the way to take it out again. Two commands cannot share a key. */
  add(command: StudioCommand): () => void {
    if (this.#commands.has(command.id)) throw new Error(`there is a command ${command.id} already`)
    for (const key of command.keys) {
      const owner = this.#keys.get(key)
      if (owner) throw new Error(`${key} belongs to ${owner} already`)
      if (KEPT_BY_BROWSER.includes(key)) throw new Error(`the browser keeps ${key} for itself`)
    }
    this.#commands.set(command.id, command)
    for (const key of command.keys) this.#keys.set(key, command.id)
    return () => {
      this.#commands.delete(command.id)
      for (const key of command.keys) this.#keys.delete(key)
    }
  }

  isEnabled(command: StudioCommand): boolean {
    return command.enabled?.() ?? true
  }

  /** Do a command by name; false where there is none or it cannot be done now. */
  run(id: string): boolean {
    const command = this.#commands.get(id)
    if (!command || !this.isEnabled(command)) return false
    command.run()
    return true
  }

  /** Do what a key press means here; true when it was taken. */
  key(event: KeyboardEvent): boolean {
    if (event.defaultPrevented || event.isComposing) return false
    const name = keyName(event)
    const command = this.#commands.get(this.#keys.get(name) ?? '')
    if (!command) return false
    if (isTyping(event.target) && (command.textKeeps || !actsWhileTyping(name))) return false
    if (!actsWhileTyping(name) && takesPlainKey(event.target, name)) return false
    if (event.repeat && !command.id.startsWith('timeline.')) return true
    if (this.isEnabled(command)) command.run()
    return true
  }

  /** Commands whose title or menu holds all words of a query, in the order of menus. */
  search(query: string): readonly StudioCommand[] {
    const words = query.toLowerCase().split(/\s+/).filter(Boolean)
    return this.all
      .filter(one => words.every(word => `${one.menu} ${one.title}`.toLowerCase().includes(word)))
      .sort((a, b) => MENUS.indexOf(a.menu) - MENUS.indexOf(b.menu))
  }
}
