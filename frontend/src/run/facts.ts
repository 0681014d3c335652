/** What a recording says about its run (docs/reference/recording.md). SI units; null where a number is not known. */

/** One driven axis of a robot. */
export interface AxisFacts {
  readonly name: string
  readonly type: 'revolute' | 'prismatic'
  readonly lower: number | null
  readonly upper: number | null
  readonly max_speed: number | null
  readonly max_effort: number | null
  readonly max_current: number | null
}

/** Where a group of parameters comes from. */
export interface ParameterOrigin {
  readonly parameters: string
  readonly kind: string
  readonly source: string
}

/** One robot with its controller and the program that it ran. */
export interface StationFacts {
  readonly name: string
  readonly program: string
  /** Name of the text in which the channel `line` counts. */
  readonly source: string
  readonly icr_id: string
  readonly law: string
  readonly control_hz: number | null
  readonly interpolation_ticks: number
  readonly plant_steps: number
  readonly robot: string
  readonly title: string
  readonly axes: readonly AxisFacts[]
  readonly origins: readonly ParameterOrigin[]
  readonly skipped_moves: number
}

export interface RunFacts {
  /** Version of ropsim that made the run. */
  readonly ropsim: string
  readonly project: string
  readonly fidelity: 'dynamic' | 'kinematic'
  readonly record_hz: number | null
  readonly checked: readonly string[]
  readonly inputs: readonly { readonly time: number; readonly signal: string; readonly value: number }[]
  readonly parts_left: readonly string[]
  readonly destinations: { readonly wanted: number; readonly reached: number }
  readonly stations: readonly StationFacts[]
}
