/**
 * The Markdown of the documentation as plain values: headings, paragraphs, lists, tables, code. What is written
 * in it stays text; the panel makes elements of the values, so nothing of a page can become markup.
 */

export type Inline =
  | { readonly kind: 'text' | 'code' | 'strong' | 'emphasis'; readonly text: string }
  | { readonly kind: 'link'; readonly text: string; readonly target: string }

export type Block =
  | {
      readonly kind: 'heading'
      readonly level: number
      readonly id: string
      readonly text: readonly Inline[]
    }
  | { readonly kind: 'paragraph'; readonly text: readonly Inline[] }
  | { readonly kind: 'list'; readonly ordered: boolean; readonly items: readonly (readonly Inline[])[] }
  | { readonly kind: 'table'; readonly head: readonly Cell[]; readonly rows: readonly (readonly Cell[])[] }
  | { readonly kind: 'code'; readonly language: string; readonly text: string }

export type Cell = readonly Inline[]

const ITEM = /^(?:[-*]|\d+\.) +/

/** The blocks of a page, in their order. */
export function blocksOf(page: string): readonly Block[] {
  const lines = page.split('\n')
  const blocks: Block[] = []
  let at = 0
  const line = () => lines[at] ?? ''
  /** Take lines as long as they go on with what the first one began. */
  const take = (goesOn: (line: string) => boolean): string[] => {
    const taken = [line()]
    for (at++; at < lines.length && goesOn(line()); at++) taken.push(line())
    return taken
  }
  while (at < lines.length) {
    const first = line()
    const heading = /^(#{1,6}) +(.*)$/.exec(first)
    if (first.trim() === '') at++
    else if (heading) {
      const text = inlinesOf(heading[2] ?? '')
      blocks.push({ kind: 'heading', level: heading[1]?.length ?? 1, id: slug(plain(text)), text })
      at++
    } else if (first.startsWith('```')) {
      const body = take(one => one !== '```').slice(1)
      at++
      blocks.push({ kind: 'code', language: /^```(\w*)/.exec(first)?.[1] ?? '', text: body.join('\n') })
    } else if (first.startsWith('    ')) {
      const body = take(one => one.startsWith('    '))
      blocks.push({ kind: 'code', language: '', text: body.map(one => one.slice(4)).join('\n') })
    } else if (first.startsWith('|')) {
      const [head, , ...rows] = take(one => one.startsWith('|')).map(cellsOf)
      blocks.push({ kind: 'table', head: head ?? [], rows })
    } else if (ITEM.test(first)) {
      const taken = take(one => one.trim() !== '' && (ITEM.test(one) || one.startsWith(' ')))
      blocks.push({ kind: 'list', ordered: /^\d/.test(first), items: itemsOf(taken) })
    } else {
      const taken = take(one => one.trim() !== '' && !/^(#|```|\|)/.test(one) && !ITEM.test(one))
      blocks.push({ kind: 'paragraph', text: inlinesOf(taken.join(' ')) })
    }
  }
  return blocks
}

/** A heading and what stands below it, up to the next heading. */
export interface Section {
  readonly id: string
  readonly level: number
  readonly title: string
  readonly blocks: readonly Block[]
  /** All words of the section in small letters, for searching. */
  readonly words: string
}

export function sectionsOf(page: string): readonly Section[] {
  const groups: Block[][] = []
  for (const block of blocksOf(page)) {
    const last = groups.at(-1)
    if (block.kind === 'heading' || !last) groups.push([block])
    else last.push(block)
  }
  return groups.map(blocks => {
    const [first] = blocks
    const heading = first?.kind === 'heading' ? first : null
    return {
      id: heading?.id ?? '',
      level: heading?.level ?? 1,
      title: heading ? plain(heading.text) : '',
      blocks,
      words: blocks.map(wordsOf).join(' ').toLowerCase(),
    }
  })
}

/** The sections that hold all words of a query. */
export function matchingSections(sections: readonly Section[], query: string): readonly Section[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean)
  return sections.filter(one => words.every(word => one.words.includes(word)))
}

const INLINE =
  /`` ?(.+?) ?``|`([^`]+)`|\*\*([^*]+(?:\*[^*]+)*)\*\*|(?<![\w*])\*([^*\s](?:[^*]*[^*\s])?)\*(?![\w*])|\[([^\]]+)\]\(([^)\s]+)\)/g

export function inlinesOf(text: string): readonly Inline[] {
  const found: Inline[] = []
  let end = 0
  const plainTo = (to: number) => {
    if (to > end) found.push({ kind: 'text', text: text.slice(end, to).replace(/\\([\\`*_|[\]])/g, '$1') })
  }
  for (const match of text.matchAll(INLINE)) {
    plainTo(match.index)
    end = match.index + match[0].length
    const [, wide, code, strong, emphasis, label, target] = match
    if (wide ?? code) found.push({ kind: 'code', text: (wide ?? code ?? '').replace(/\\\|/g, '|') })
    else if (strong) found.push({ kind: 'strong', text: strong.replaceAll('`', '') })
    else if (emphasis) found.push({ kind: 'emphasis', text: emphasis })
    else found.push({ kind: 'link', text: (label ?? '').replaceAll('`', ''), target: target ?? '' })
  }
  plainTo(text.length)
  return found
}

/** The name of a heading in addresses, as code hosts make it. */
export function slug(title: string): string {
  return title
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, '')
    .replace(/\s/g, '-')
}

function plain(text: readonly Inline[]): string {
  return text.map(one => one.text).join('')
}

function wordsOf(block: Block): string {
  if (block.kind === 'code') return block.text
  if (block.kind === 'list') return block.items.map(plain).join(' ')
  if (block.kind === 'table') return [block.head, ...block.rows].flat().map(plain).join(' ')
  return plain(block.text)
}

function itemsOf(lines: readonly string[]): readonly (readonly Inline[])[] {
  const items: string[] = []
  for (const line of lines) {
    if (ITEM.test(line)) items.push(line.replace(ITEM, ''))
    else items.push(`${items.pop() ?? ''} ${line.trim()}`)
  }
  return items.map(inlinesOf)
}

/** The cells of a row; a bar behind a backslash belongs to its cell. */
function cellsOf(row: string): readonly Cell[] {
  const inner = row.trim().replace(/^\|/, '').replace(/\|$/, '')
  return inner.split(/(?<!\\)\|/).map(cell => inlinesOf(cell.trim()))
}
