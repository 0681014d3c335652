/** Binary search in ascending times. */

/** How many of `items` have a time of at most `time`. */
export function countUpTo<T>(items: ArrayLike<T>, time: number, timeOf: (item: T) => number): number {
  let low = 0
  let high = items.length
  while (low < high) {
    const middle = (low + high) >> 1
    const item = items[middle]
    if (item !== undefined && timeOf(item) <= time) low = middle + 1
    else high = middle
  }
  return low
}

/** How many of the ascending `times` are at most `time`. */
export function timesUpTo(times: ArrayLike<number>, time: number): number {
  return countUpTo(times, time, itself)
}

function itself(time: number): number {
  return time
}
