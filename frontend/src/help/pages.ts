/** The pages of the documentation that travel with the studio: they are read without a network. */
import cellFile from '../../../docs/reference/cell-file.md?raw'
import commands from '../../../docs/reference/commands.md?raw'
import language from '../../../docs/reference/language.md?raw'
import { sectionsOf } from './markdown'
import type { HelpTopic } from './topics'

export type PageTopic = Exclude<HelpTopic, 'keys'>

export const PAGES = {
  language: sectionsOf(language),
  cell: sectionsOf(cellFile),
  commands: sectionsOf(commands),
} as const

const FILES: Readonly<Record<string, PageTopic>> = {
  'language.md': 'language',
  'cell-file.md': 'cell',
  'commands.md': 'commands',
}

/** Where a link of a page leads inside of the help; null for pages that are not here. */
export function placeOf(target: string, page: PageTopic): { topic: PageTopic; id: string } | null {
  const [file = '', id = ''] = target.split('#')
  const topic = file ? FILES[file] : page
  return topic ? { topic, id } : null
}
