/** How deep a line of a task text stands, by the lines above it and by its own first word. */
import { ANY, closed, divided, goesOn, MARKS, opened, statementAt } from './block_lines'

/** A line above: its text and the column in which its first word stands. */
export interface Row {
  readonly text: string
  readonly indent: number
}

interface Block {
  readonly opener: string
  readonly indent: number
}

/**
 * The column in which a line begins.
 *
 * A closing or dividing word stands where its block was opened; a statement that goes on stands behind its open
 * bracket; every other line stands as the one before it, deeper by a unit where that opens or divides a block.
 * @param above the lines above it, from the beginning of the text or of the task on
 * @param text of the line, as far as it is typed
 * @param unit columns of one block
 */
export function depthOf(above: readonly Row[], text: string, unit: number): number {
  const lines = above.map(row => row.text)
  const blocks: Block[] = []
  let below = 0
  for (let at = 0; at < above.length; ) {
    const statement = statementAt(lines, at)
    const first = at
    at += statement.length
    if (at === above.length && goesOn(statement, text)) return continued(above.slice(first), text, unit)
    const { indent } = above[first] ?? { indent: 0 }
    const written = statement.join('\n')
    if (written.trim() === '') continue
    const opener = opened(written)
    const ended = closedBlock(blocks, written)
    if (opener === 'task') blocks.length = 0
    if (opener) blocks.push({ opener, indent })
    else if (ended >= 0) blocks.length = divided(written).length > 0 ? ended + 1 : ended
    below = opener || divided(written).length > 0 ? indent + unit : indent
  }
  return blocks[closedBlock(blocks, text)]?.indent ?? below
}

/** Which of the open blocks a line closes or divides, -1 for none. */
function closedBlock(blocks: readonly Block[], line: string): number {
  const closer = closed(line)
  if (closer === ANY) return blocks.length - 1
  const openers = closer ? [closer] : divided(line)
  return Math.max(...openers.map(one => blocks.map(block => block.opener).lastIndexOf(one)), -1)
}

/** The column in which a statement goes on: behind its innermost open bracket, else deeper by a unit. */
function continued(rows: readonly Row[], text: string, unit: number): number {
  const open: { inside: number; end: number }[] = []
  for (const row of rows) {
    const begin = row.indent - (row.text.length - row.text.trimStart().length)
    for (const mark of row.text.matchAll(MARKS)) {
      const column = begin + mark.index
      if (mark[0] === '(' || mark[0] === '[') {
        const isLast = /^\s*(?:#.*|\/\/.*)?$/.test(row.text.slice(mark.index + 1))
        open.push(
          isLast ? { inside: row.indent + unit, end: row.indent } : { inside: column + 1, end: column },
        )
      } else if (mark[0] === ')' || mark[0] === ']') open.pop()
    }
  }
  const bracket = open.at(-1)
  if (!bracket) return (rows[0]?.indent ?? 0) + unit
  return /^\s*[)\]]/.test(text) ? bracket.end : bracket.inside
}
