/** The commands of the shell. Panels add their own where they need to. */
import { TOPICS } from '../help/topics'
import { commandWords as titles } from '../text/commands'
import { editWords } from '../text/edit'
import type { Add, Extra } from './command_groups'
import type { Menu } from './commands'
import { EDITS, type EditEntry } from './edit_table'
import { addFile } from './file_commands'
import { addSimulate } from './simulate_commands'
import type { Studio } from './studio'
import { addView } from './view_commands'

/** Add all of them; returns the way to take them out again. */
export function addCommands(studio: Studio, openPalette: () => void): () => void {
  const removals: (() => void)[] = []
  const group = (menu: Menu, name: string) => {
    return (id: string, title: string, keys: readonly string[], run: () => void, extra: Extra = {}) => {
      removals.push(studio.commands.add({ id, title, menu, group: name, keys, run, ...extra }))
    }
  }
  addFile(studio, group)
  addEdit(studio, group('Edit', 'undo'))
  for (const [name, entries] of Object.entries(EDITS)) addEntries(studio, group('Edit', name), entries)
  addView(studio, group)
  addSimulate(studio, group)
  const help = group('Help', 'help')
  help('help.palette', titles.palette, ['Ctrl+K', 'F1'], openPalette)
  for (const topic of TOPICS) {
    help(`help.${topic}`, titles.help[topic], topic === 'keys' ? ['Shift+F1'] : [], () => {
      studio.store.setState({ help: topic })
      studio.dock?.show('help')
    })
  }
  return () => {
    for (const remove of removals) remove()
  }
}

function addEntries(studio: Studio, add: Add, entries: readonly EditEntry[]): void {
  const state = () => studio.store.getState()
  for (const entry of entries) {
    const run = () => {
      if (!studio.desk.act(entry)) studio.dock?.show('program')
    }
    add(`edit.${entry.action}`, editWords[entry.action], entry.keys, run, {
      enabled: () => state().document !== '' && (!entry.writes || state().editing),
    })
  }
}

function addEdit(studio: Studio, add: Add): void {
  const { undo } = studio
  add('edit.undo', titles.undo, ['Ctrl+Z'], () => undo.undo(), {
    enabled: () => undo.next !== null,
    textKeeps: true,
  })
  add('edit.redo', titles.redo, ['Ctrl+Shift+Z', 'Ctrl+Y'], () => undo.redo(), {
    enabled: () => undo.nextRedo !== null,
    textKeeps: true,
  })
}
