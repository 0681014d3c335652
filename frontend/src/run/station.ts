/** Stations of a cell: robots with the programs that they run, and the names of what is theirs. */

/** A station of a run with its program. */
export interface RunStation {
  readonly name: string
  /** Name of its program; empty where it has none. */
  readonly program: string
  /** Name of the text whose lines its channel `line` counts. */
  readonly source: string
}

/** The station of a cell that has one: its bodies and channels are called without it. */
export const ROBOT = 'robot'

/** What stands before the names of bodies and channels of a station or device. */
export function prefixOf(owner: string): string {
  return owner === ROBOT || owner === '' ? '' : `${owner}/`
}

/** Name of the channel with a quantity of a station or device: `q`, or `left/q`. */
export function channelOf(quantity: string, owner: string): string {
  return prefixOf(owner) + quantity
}

/** A text with the name of a station before it where there are several ones. */
export function labelled(stations: readonly unknown[], station: string, text: string): string {
  return stations.length > 1 && station ? `${station}: ${text}` : text
}
