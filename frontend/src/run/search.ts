/** Binary search in ascending times. */

/** How many of the first `count` items have a time of at most `time`. */
export function countUpTo<T>(
  items: ArrayLike<T>,
  time: number,
  timeOf: (item: T) => number,
  count = items.length,
): number {
  let low = 0
  let high = count
  while (low < high) {
    const middle = (low + high) >> 1
    const item = items[middle]
    if (item !== undefined && timeOf(item) <= time) low = middle + 1
    else high = middle
  }
  return low
}

/** How many of the first `count` ascending times are at most `time`. */
export function timesUpTo(times: ArrayLike<number>, time: number, count = times.length): number {
  return countUpTo(times, time, itself, count)
}

/** The last item that passes a test. */
export function lastWhere<T>(items: readonly T[], test: (item: T) => boolean): T | undefined {
  for (let at = items.length - 1; at >= 0; at--) {
    const item = items[at]
    if (item !== undefined && test(item)) return item
  }
  return undefined
}

function itself(time: number): number {
  return time
}
