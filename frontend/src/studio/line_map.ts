/** Where the lines of one text stand in another one that was edited from it. */

export interface LineMap {
  /** Line (from 1) of the newer text; null where the line is gone or says something else. */
  readonly toNew: (line: number) => number | null
  /** Line (from 1) of the older text; null where the line is new. */
  readonly toOld: (line: number) => number | null
}

/** Beyond so many pairs of lines the middle of two texts is not compared line by line. */
const MOST_PAIRS = 1_000_000

export const SAME_LINES: LineMap = { toNew: line => line, toOld: line => line }

/** Lines of equal content belong together; as many edited lines as before keep their places, too. */
export function lineMap(older: string, newer: string): LineMap {
  if (older === newer) return SAME_LINES
  const a = linesOf(older)
  const b = linesOf(newer)
  const there = new Int32Array(a.length).fill(-1)
  let head = 0
  while (head < a.length && head < b.length && a[head] === b[head]) there[head] = head++
  let tail = 0
  while (tail < a.length - head && tail < b.length - head && a.at(-1 - tail) === b.at(-1 - tail)) {
    tail += 1
    there[a.length - tail] = b.length - tail
  }
  const middle = { a: a.slice(head, a.length - tail), b: b.slice(head, b.length - tail) }
  for (const [old, fresh] of common(middle.a, middle.b)) there[head + old] = head + fresh
  keepEdited(there, b.length)
  const back = new Int32Array(b.length).fill(-1)
  for (const [old, fresh] of there.entries()) if (fresh >= 0) back[fresh] = old
  return { toNew: line => numberOf(there, line), toOld: line => numberOf(back, line) }
}

/** Blanks at the ends of a line say nothing. */
function linesOf(text: string): string[] {
  return text.split(/\r\n|\n|\r/).map(line => line.trim())
}

function numberOf(places: Int32Array, line: number): number | null {
  const found = places[line - 1]
  return found === undefined || found < 0 ? null : found + 1
}

/** Pairs of a longest common subsequence. */
function common(a: readonly string[], b: readonly string[]): [number, number][] {
  if (a.length === 0 || b.length === 0 || a.length * b.length > MOST_PAIRS) return []
  const width = b.length + 1
  const longest = new Uint32Array((a.length + 1) * width)
  const at = (row: number, column: number) => longest[row * width + column] ?? 0
  for (let row = a.length - 1; row >= 0; row -= 1) {
    for (let column = b.length - 1; column >= 0; column -= 1) {
      longest[row * width + column] =
        a[row] === b[column]
          ? at(row + 1, column + 1) + 1
          : Math.max(at(row + 1, column), at(row, column + 1))
    }
  }
  const pairs: [number, number][] = []
  let row = 0
  let column = 0
  while (row < a.length && column < b.length) {
    if (a[row] === b[column]) pairs.push([row++, column++])
    else if (at(row + 1, column) >= at(row, column + 1)) row += 1
    else column += 1
  }
  return pairs
}

/** Between lines that stayed, as many edited lines as there were are the same lines. */
function keepEdited(there: Int32Array, count: number): void {
  let row = 0
  while (row < there.length) {
    if ((there[row] ?? -1) >= 0) {
      row += 1
      continue
    }
    let end = row
    while (end < there.length && (there[end] ?? -1) < 0) end += 1
    const from = row > 0 ? (there[row - 1] ?? -1) + 1 : 0
    const to = end < there.length ? (there[end] ?? count) : count
    if (to - from === end - row) for (let at = row; at < end; at += 1) there[at] = from + at - row
    row = end
  }
}
