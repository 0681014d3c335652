/** The smallest changes that make one text of another, so that cursor, marks and history stay where they can. */

export interface Replacement {
  readonly from: number
  readonly to: number
  readonly insert: string
}

/** Lines of a text from `from` to `to`, each with its line end. */
interface Part {
  readonly lines: readonly string[]
  readonly from: number
  readonly to: number
}

/** Parts between lines that stay are compared anew so many times at most: the time stays linear. */
const ROUNDS = 4

/** The changes in their order, none where the texts are the same: of lines, and in them of the letters that differ. */
export function replacements(before: string, after: string): readonly Replacement[] {
  if (before === after) return []
  // The last line is one like the others: it ends, too.
  const [old, now] = [linesOf(`${before}\n`), linesOf(`${after}\n`)]
  const changes: Replacement[] = []
  let place = 0
  let line = 0
  for (const [a, b] of differing(whole(old), whole(now), ROUNDS)) {
    for (; line < a.from; line += 1) place += old[line]?.length ?? 0
    const change = replacement(textOf(a), textOf(b))
    if (!change) continue
    const moved = { ...change, from: place + change.from, to: place + change.to }
    changes.push(moved.to > before.length ? atTheEnd(moved) : moved)
  }
  return changes
}

/** Lines that come or go at the end do so with the line end before them, as there is none behind. */
function atTheEnd({ from, to, insert }: Replacement): Replacement {
  return { from: from - 1, to: to - 1, insert: insert && `\n${insert.slice(0, -1)}` }
}

/** The one change between two texts, null where they are the same. */
function replacement(before: string, after: string): Replacement | null {
  if (before === after) return null
  const start = alike(before.length, after.length, at => before[at] === after[at])
  const [rest, other] = [before.length - start, after.length - start]
  const same = alike(rest, other, at => before.at(-1 - at) === after.at(-1 - at))
  return { from: start, to: before.length - same, insert: after.slice(start, after.length - same) }
}

/** The parts of two texts that differ, in order. */
function differing(a: Part, b: Part, rounds: number): (readonly [Part, Part])[] {
  const isSame = (x: number, y: number) => a.lines[x] === b.lines[y]
  const head = alike(size(a), size(b), at => isSame(a.from + at, b.from + at))
  const tail = alike(size(a) - head, size(b) - head, at => isSame(a.to - 1 - at, b.to - 1 - at))
  const [x, y] = [inner(a, a.from + head, a.to - tail), inner(b, b.from + head, b.to - tail)]
  if (size(x) === 0 && size(y) === 0) return []
  const staying = size(x) > 0 && size(y) > 0 && rounds > 0 ? rising(lonePairs(x, y)) : []
  if (staying.length === 0) return [[x, y]]
  const parts: (readonly [Part, Part])[] = []
  let [atX, atY] = [x.from, y.from]
  for (const [endX, endY] of [...staying, [x.to, y.to] as const]) {
    parts.push(...differing(inner(x, atX, endX), inner(y, atY, endY), rounds - 1))
    ;[atX, atY] = [endX + 1, endY + 1]
  }
  return parts
}

/** Lines that stand once in either part, by their places, in the order of the first. */
function lonePairs(a: Part, b: Part): (readonly [number, number])[] {
  const [inA, inB] = [loneLines(a), loneLines(b)]
  return [...inA].flatMap(([line, x]) => {
    const y = inB.get(line)
    return x < 0 || y === undefined || y < 0 ? [] : [[x, y] as const]
  })
}

/** The place of each line of a part, -1 for one that stands there again. */
function loneLines(part: Part): ReadonlyMap<string, number> {
  const places = new Map<string, number>()
  for (let at = part.from; at < part.to; at += 1) {
    const line = part.lines[at] ?? ''
    places.set(line, places.has(line) ? -1 : at)
  }
  return places
}

/** The most pairs that rise in both places (patience sorting). */
function rising(pairs: readonly (readonly [number, number])[]): (readonly [number, number])[] {
  const ends: number[] = []
  const before: number[] = []
  for (const [at, pair] of pairs.entries()) {
    let [low, high] = [0, ends.length]
    while (low < high) {
      const middle = (low + high) >> 1
      if ((pairs[ends[middle] ?? 0]?.[1] ?? 0) < pair[1]) low = middle + 1
      else high = middle
    }
    before[at] = low > 0 ? (ends[low - 1] ?? -1) : -1
    ends[low] = at
  }
  const found: (readonly [number, number])[] = []
  for (let at = ends.at(-1) ?? -1; at >= 0; at = before[at] ?? -1) found.push(pairs[at] as [number, number])
  return found.reverse()
}

function alike(a: number, b: number, isSame: (at: number) => boolean): number {
  const shorter = Math.min(a, b)
  let count = 0
  while (count < shorter && isSame(count)) count += 1
  return count
}

function linesOf(text: string): readonly string[] {
  return text.match(/[^\n]*\n/g) ?? []
}

function whole(lines: readonly string[]): Part {
  return { lines, from: 0, to: lines.length }
}

function inner({ lines }: Part, from: number, to: number): Part {
  return { lines, from, to }
}

function size({ from, to }: Part): number {
  return to - from
}

function textOf({ lines, from, to }: Part): string {
  return lines.slice(from, to).join('')
}
