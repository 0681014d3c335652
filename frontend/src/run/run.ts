/** A run as views, plots and tables see it: one recording, asked by time. Live and finished runs look alike. */
import type { Contact } from '../wire/facts'
import type { ResultFigures } from '../wire/result'
import type { RunStation } from './station'

export interface Span {
  readonly source: string
  readonly line: number
  readonly column: number
  readonly end_line: number
  readonly end_column: number
}

export interface Finding {
  readonly code: string
  readonly severity: 'error' | 'warning' | 'info' | 'hint'
  /** What made it: compiling the texts, or carrying the program out. Absent in packs of older versions. */
  readonly stage?: 'compiling' | 'run'
  readonly message: string
  readonly hint: string
  readonly span: Span | null
  /** Simulated time [s] at which it arose, null where it has none. */
  readonly time: number | null
  /** From where it likely follows; null or absent where it stands alone. */
  readonly follows?: { readonly source: string; readonly line: number } | null
  /** Where in the world it is [m]; null or absent where it has no place. */
  readonly place?: readonly [number, number, number] | null
}

export interface RunEvent {
  readonly time: number
  readonly duration: number
  readonly kind: string
  readonly text: string
  /** Name of the station whose program made it; empty for what belongs to the cell. */
  readonly station: string
  readonly span: Span | null
  readonly data: Readonly<Record<string, unknown>>
}

/** Tool paths that followed upon each other, and how true the arm was to them; lengths in m, times in s. */
export interface Contour {
  readonly station: string
  readonly name: string
  readonly start: number
  readonly end: number
  readonly path_max: number
  readonly path_mean: number
  /** When the path error was the largest. */
  readonly time: number
  readonly tracking_max: number
  readonly tracking_end: number
  readonly overshoot: number | null
  /** Of the base frame, in which it is drawn. */
  readonly axes: readonly [string, string]
  /** By which the distance of the attained path is enlarged. */
  readonly factor: number
  readonly wanted: readonly (readonly [number, number])[]
  readonly attained: readonly (readonly [number, number])[]
}

export interface ChannelInfo {
  readonly name: string
  readonly unit: string
  /** Of each column, where they differ. */
  readonly units?: readonly string[] | undefined
  /** Names of the columns; one empty name for a channel of one column. */
  readonly columns: readonly string[]
  readonly description: string
  /** `joints`, `tcp`, `program`, `signals`, `devices`; for grouping in lists. */
  readonly group: string
  /** Name of the station or device that it is of; empty for what belongs to the cell. */
  readonly subject: string
  /** Least and greatest recorded value of each column. */
  readonly min: readonly number[]
  readonly max: readonly number[]
}

/** One column over time; `times` ascending [s]. `held`: the value holds until the next time, else it is linear. */
export interface Series {
  readonly times: Float64Array
  readonly values: Float64Array
  readonly held: boolean
}

export interface Run {
  /** Robots with what they run, in the order of the cell. */
  readonly stations: readonly RunStation[]
  readonly fidelity: 'dynamic' | 'kinematic'
  /** Grows while the run is live. */
  readonly duration: number
  readonly live: boolean
  readonly channels: readonly ChannelInfo[]
  readonly events: readonly RunEvent[]
  readonly findings: readonly Finding[]
  /** How true the arm was to its contours; undefined while it is live. */
  readonly contours?: readonly Contour[] | undefined
  /** What is to be known of the run at once; undefined while it is live. */
  readonly result?: ResultFigures | undefined
  /** Penetrations of bodies, in order of time; undefined where they are not known. */
  readonly contacts?: readonly Contact[] | undefined
  /** Value of a column at a time; NaN where there is none. Times outside are clamped. */
  value(channel: string, column: number, time: number): number
  /** A column as samples; the same object until the run grows. Undefined for unknown channels. */
  series(channel: string, column: number): Series | undefined
  /**
   * World poses of all bodies at a time: 7 numbers each into `poses` (x, y, z, w, x, y, z), 1 or 0 into
   * `visible`. Lengths are 7 × and 1 × the number of bodies of the scene.
   */
  bodies(time: number, poses: Float32Array, visible: Uint8Array): void
  /** TCP positions of a station in W, 3 numbers per sample, and the times of the samples. */
  trail(
    kind: 'attained' | 'command',
    station: string,
  ): { readonly times: Float64Array; readonly points: Float32Array }
}
