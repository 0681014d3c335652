/** What a statement of a task text does to blocks: it opens, closes or divides one; and where it ends. */
import { CLOSERS, DIVIDERS, HEADS } from './block_words'

/** What `end` closes: the innermost block, whichever it is. */
export const ANY = 'block'

/** A statement goes on over at most so many lines, as the compiler reads them. */
const MAX_JOINED = 20

const OPENERS = new Set(Object.values(CLOSERS))
const END = /^\s*end\s*\.?\s*(?:#.*|\/\/.*)?$/i
const HEAD = /^\s*(?:\d+\.\s+)?([A-Za-z_]\w*)/
const ONE_LINE_IF = /\bthen\s+[^\s#/]/i
const TEXTS = /"(?:[^"\\\n]|\\.)*"?/g
const NOTES = /#.*|\/\/.*/g

/** Texts, comments and brackets of a line, in order. */
export const MARKS = /"(?:[^"\\]|\\.)*(?:"|\\?$)|#.*|\/\/.*|[()[\]]/g

function headOf(line: string): string {
  return HEAD.exec(line)?.[1]?.toLowerCase() ?? ''
}

/** The word of the block that a statement opens, empty for none. */
export function opened(statement: string): string {
  const head = headOf(statement)
  if (!OPENERS.has(head)) return ''
  const bare = statement.replace(TEXTS, '""').replace(NOTES, '')
  return head === 'if' && ONE_LINE_IF.test(bare) ? '' : head
}

/** The opener of the block that a statement closes, `ANY` for `end`, empty for none. */
export function closed(statement: string): string {
  return END.test(statement) ? ANY : (CLOSERS[headOf(statement)] ?? '')
}

/** The openers of the blocks that a statement may divide, as `else` does. */
export function divided(statement: string): readonly string[] {
  return DIVIDERS[headOf(statement)] ?? []
}

/** What of a line decides where it stands below given lines: lines that are alike in it stand alike. */
export function kindOf(line: string): string {
  const isEnd = /^\s*[)\]]/.test(line)
  return [closed(line), ...divided(line), HEADS.has(headOf(line)), isEnd].join()
}

/** How many more brackets a line opens than it closes. */
function bracketDepth(line: string): number {
  let depth = 0
  for (const [mark] of line.matchAll(MARKS)) {
    if (mark === '(' || mark === '[') depth += 1
    else if (mark === ')' || mark === ']') depth -= 1
  }
  return depth
}

/** Whether a statement with an open bracket or a final backslash goes on in a line that may still be empty. */
export function goesOn(lines: readonly string[], following: string): boolean {
  if (lines.length >= MAX_JOINED) return false
  if (lines.at(-1)?.endsWith('\\')) return true
  if (lines.reduce((depth, line) => depth + bracketDepth(line), 0) <= 0) return false
  return !END.test(following) && !HEADS.has(headOf(following))
}

/** The lines of the statement that begins at `first`. */
export function statementAt(lines: readonly string[], first: number): readonly string[] {
  const found = [lines[first] ?? '']
  for (let at = first + 1; at < lines.length; at += 1) {
    const line = lines[at] ?? ''
    const isBlank = line.trim() === '' && !found.at(-1)?.endsWith('\\')
    if (isBlank || !goesOn(found, line)) break
    found.push(line)
  }
  return found
}
