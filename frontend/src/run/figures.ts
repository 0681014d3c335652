/** The figures of a finished run, as its pack tells them. */

/** The worst share of a limit among the joints; `line` 0 for none. */
export interface PeakFigure {
  readonly share: number
  /** How it stands to the limit; the report says it by the same rule. */
  readonly closeness: 'far' | 'near' | 'beyond'
  readonly station: string
  readonly joint: string
  readonly line: number
  readonly time: number
}

/** The result of a run: what a strip shows of it. SI units; figures that a run does not know are null. */
export interface ResultFigures {
  readonly verdict: { readonly kind: 'good' | 'doubtful' | 'failed'; readonly text: string }
  /** What was done to the run by hand, in words; empty for nothing. It stands in `unchecked`, too. */
  readonly given: string
  /** One line: what the verdict did not look at. It stands beside the verdict, wherever that is shown. */
  readonly unchecked: string
  readonly cycle_time: number
  /** False where a move was skipped: the cycle time is not that of the program then. */
  readonly cycle_time_valid: boolean
  /** Time spent waiting for the arm to settle after moves [s], its share of the cycle time, when and where longest. */
  readonly settling: {
    readonly total: number
    readonly share: number
    /** Null where no move settled. */
    readonly time: number | null
    readonly station: string
    /** From 1; 0 for none. */
    readonly line: number
  }
  readonly peak_torque: PeakFigure | null
  readonly peak_speed: PeakFigure | null
  readonly closest_limit: {
    readonly margin: number
    readonly unit: 'rad' | 'm'
    readonly station: string
    readonly joint: string
    readonly side: 'lower' | 'upper'
    readonly line: number
    readonly time: number
  } | null
  /** Largest distance of the TCP from the commanded path [m]; null where no move has a path. */
  readonly path_error: {
    readonly max: number
    readonly station: string
    readonly line: number
    readonly time: number
  } | null
  readonly errors: number
  readonly warnings: number
  readonly hints: number
  readonly moves: number
}
