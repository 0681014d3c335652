"""The result of a run as a strip shows it: verdict, open points, the worst figure of each kind."""

from typing import Literal

from ropsim.core import frozen_dataclass
from ropsim.flow import Destinations
from ropsim.views.summary.joint_summary import Closeness, LimitSide
from ropsim.views.summary.verdict import VerdictText


@frozen_dataclass
class SettlingFigure:
    """Time spent waiting for the arm to settle after moves.

    Attributes:
        total: over all moves [s].
        share: of the cycle time; of several stations, of their cycle times together.
        time: when the longest wait began [s]; None where no move settled.
        station: whose wait that was; empty for none.
        line: its source line, from 1; 0 for none.
    """

    total: float
    share: float
    time: float | None
    station: str
    line: int


@frozen_dataclass
class PeakFigure:
    """The worst share of a limit among the joints.

    Attributes:
        share: peak over limit.
        closeness: how it stands to the limit; the report says it by the same rule.
        station: whose joint it is.
        joint: its name.
        line: source line, from 1; 0 for none.
        time: when [s].
    """

    share: float
    closeness: Closeness
    station: str
    joint: str
    line: int
    time: float


@frozen_dataclass
class MarginFigure:
    """The least margin to an end of the range of a joint.

    Attributes:
        margin: distance left [rad | m]; negative beyond the end.
        closeness: how it stands to the end; the report says it by the same rule.
        unit: of the margin.
        station: whose joint it is.
        joint: its name.
        side: which end it is.
        line: source line, from 1; 0 for none.
        time: when [s].
    """

    margin: float
    closeness: Closeness
    unit: Literal["rad", "m"]
    station: str
    joint: str
    side: LimitSide
    line: int
    time: float


@frozen_dataclass
class PathFigure:
    """The largest distance of the TCP from the commanded path.

    Attributes:
        max: that distance [m].
        station: whose tool it is.
        line: source line of the move, from 1.
        time: when [s].
    """

    max: float
    station: str
    line: int
    time: float


@frozen_dataclass
class ForceFigure:
    """The greatest force of a contact.

    Attributes:
        max: that force [N].
        station: on whose tool or held part.
        line: source line, from 1; 0 for none.
        time: when [s].
    """

    max: float
    station: str
    line: int
    time: float


@frozen_dataclass
class ResultFigures:
    """The result of a run for a strip.

    Attributes:
        verdict: how far the run can be relied on.
        given: manual interventions, in words; empty for none. It is also part of `unchecked`.
        unchecked: one line: omitted checks of the verdict. It is shown with every verdict.
        cycle_time: end of the last motion or instruction [s].
        cycle_time_valid: false where a move was skipped or a program did not come to its end: the cycle time
            is not that of the program then.
        cycle_time_by_hand: how long the run was held and slowed within it, in words; empty for nothing. It
            stands at the cycle time, wherever that is shown.
        settling: time of settling after moves; None without drives.
        peak_torque: None where no limit is known.
        peak_speed: None where no limit is known.
        closest_limit: None where no margin is known.
        path_error: None where no move has a path of the tool, and without drives.
        errors: number of findings of this severity, repeats included.
        warnings: number of them.
        hints: number of them.
        moves: number of moves carried out.
        destinations: of the parts; None without any.
        contact_force: None where nothing was touched that pushes back.
    """

    verdict: VerdictText
    given: str
    unchecked: str
    cycle_time: float
    cycle_time_valid: bool
    cycle_time_by_hand: str
    settling: SettlingFigure | None
    peak_torque: PeakFigure | None
    peak_speed: PeakFigure | None
    closest_limit: MarginFigure | None
    path_error: PathFigure | None
    errors: int
    warnings: int
    hints: int
    moves: int
    destinations: Destinations | None
    contact_force: ForceFigure | None = None
