/** The smallest change that makes one text of another, so that cursor and history stay where they can. */

export interface Replacement {
  readonly from: number
  readonly to: number
  readonly insert: string
}

/** Null where the texts are the same. */
export function replacement(before: string, after: string): Replacement | null {
  if (before === after) return null
  const shorter = Math.min(before.length, after.length)
  let start = 0
  while (start < shorter && before[start] === after[start]) start += 1
  let same = 0
  while (same < shorter - start && before[before.length - 1 - same] === after[after.length - 1 - same])
    same += 1
  return { from: start, to: before.length - same, insert: after.slice(start, after.length - same) }
}
