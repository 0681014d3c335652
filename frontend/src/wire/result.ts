/**
 * The result of a run as a strip shows it: verdict, open points, the worst figure of each kind.
 *
 * Written by `tools/wire_types.py` from `ropsim.views.summary.result`: change the records there.
 */
import type { Destinations } from './facts'

/** A verdict and the sentence with its reasons. */
export interface VerdictText {
  readonly kind: 'good' | 'doubtful' | 'failed'
  readonly text: string
}

/** Time spent waiting for the arm to settle after moves. */
export interface SettlingFigure {
  /** Over all moves [s]. */
  readonly total: number
  /** Of the cycle time; of several stations, of their cycle times together. */
  readonly share: number
  /** When the longest wait began [s]; null where no move settled. */
  readonly time: number | null
  /** Whose wait that was; empty for none. */
  readonly station: string
  /** Its source line, from 1; 0 for none. */
  readonly line: number
}

/** The worst share of a limit among the joints. */
export interface PeakFigure {
  /** Peak over limit. */
  readonly share: number
  /** How it stands to the limit; the report says it by the same rule. */
  readonly closeness: 'far' | 'near' | 'beyond'
  /** Whose joint it is. */
  readonly station: string
  /** Its name. */
  readonly joint: string
  /** Source line, from 1; 0 for none. */
  readonly line: number
  /** When [s]. */
  readonly time: number
}

/** The least margin to an end of the range of a joint. */
export interface MarginFigure {
  /** Distance left [rad | m]; negative beyond the end. */
  readonly margin: number
  /** How it stands to the end; the report says it by the same rule. */
  readonly closeness: 'far' | 'near' | 'beyond'
  /** Of the margin. */
  readonly unit: 'rad' | 'm'
  /** Whose joint it is. */
  readonly station: string
  /** Its name. */
  readonly joint: string
  /** Which end it is. */
  readonly side: 'lower' | 'upper'
  /** Source line, from 1; 0 for none. */
  readonly line: number
  /** When [s]. */
  readonly time: number
}

/** The largest distance of the TCP from the commanded path. */
export interface PathFigure {
  /** That distance [m]. */
  readonly max: number
  /** Whose tool it is. */
  readonly station: string
  /** Source line of the move, from 1. */
  readonly line: number
  /** When [s]. */
  readonly time: number
}

/** The greatest force of a contact. */
export interface ForceFigure {
  /** That force [N]. */
  readonly max: number
  /** On whose tool or held part. */
  readonly station: string
  /** Source line, from 1; 0 for none. */
  readonly line: number
  /** When [s]. */
  readonly time: number
}

/** The result of a run for a strip. */
export interface ResultFigures {
  /** How far the run can be relied on. */
  readonly verdict: VerdictText
  /** Manual interventions, in words; empty for none. It is also part of `unchecked`. */
  readonly given: string
  /** One line: omitted checks of the verdict. It is shown with every verdict. */
  readonly unchecked: string
  /** End of the last motion or instruction [s]. */
  readonly cycle_time: number
  /**
   * False where a move was skipped or a program did not come to its end: the cycle time is not that of the
   * program then.
   */
  readonly cycle_time_valid: boolean
  /**
   * How long the run was held and slowed within it, in words; empty for nothing. It stands at the cycle time,
   * wherever that is shown.
   */
  readonly cycle_time_by_hand: string
  /** Time of settling after moves; null without drives. */
  readonly settling: SettlingFigure | null
  /** Null where no limit is known. */
  readonly peak_torque: PeakFigure | null
  /** Null where no limit is known. */
  readonly peak_speed: PeakFigure | null
  /** Null where no margin is known. */
  readonly closest_limit: MarginFigure | null
  /** Null where no move has a path of the tool, and without drives. */
  readonly path_error: PathFigure | null
  /** Number of findings of this severity, repeats included. */
  readonly errors: number
  /** Number of them. */
  readonly warnings: number
  /** Number of them. */
  readonly hints: number
  /** Number of moves carried out. */
  readonly moves: number
  /** Of the parts; null without any. */
  readonly destinations: Destinations | null
  /** Null where nothing was touched that pushes back. */
  readonly contact_force: ForceFigure | null
}
