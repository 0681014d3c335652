/** How lists of commands are written: a group of a menu, and in it one command after the other. */
import type { Menu, StudioCommand } from './commands'

export type Extra = Partial<Pick<StudioCommand, 'enabled' | 'checked' | 'textKeeps'>>

export type Add = (id: string, title: string, keys: readonly string[], run: () => void, extra?: Extra) => void

export type Grouped = (menu: Menu, name: string) => Add
