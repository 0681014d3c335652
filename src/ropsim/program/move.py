"""A motion of the structured program: target, way, settings, outputs on the way and the end."""

from ropsim.core import Span, frozen_dataclass
from ropsim.flow import Comparison, MotionKind, Side, ToolDirection
from ropsim.program.expressions import Expression


@frozen_dataclass
class Settings:
    """Modal values to set; None leaves a value unchanged.

    Attributes:
        tool: name of a tool.
        path_speed: REAL [m/s].
        ptp_speed: REAL share, (0, 1].
        orientation_speed: REAL [rad/s].
        path_acceleration: REAL [m/s²].
        ptp_acceleration: REAL share, (0, 1].
        zone: REAL [m]; a constant 0 means fine.
    """

    tool: str | None = None
    path_speed: Expression | None = None
    ptp_speed: Expression | None = None
    orientation_speed: Expression | None = None
    path_acceleration: Expression | None = None
    ptp_acceleration: Expression | None = None
    zone: Expression | None = None

    @property
    def is_empty(self) -> bool:
        """Return whether nothing is set."""
        return (
            self.tool is None
            and self.path_speed is None
            and self.ptp_speed is None
            and self.orientation_speed is None
            and self.path_acceleration is None
            and self.ptp_acceleration is None
            and self.zone is None
        )


@frozen_dataclass
class Trigger:
    """An output that is set at a place of a motion.

    Attributes:
        signal: the output.
        value: new value.
        side: end of the motion from which is counted.
        distance: REAL, way of the TCP from there [m]; None where a time is given.
        time: REAL, time from there [s]; None where a distance is given.
    """

    signal: str
    value: Expression
    side: Side
    distance: Expression | None = None
    time: Expression | None = None


@frozen_dataclass
class Guard:
    """The condition on one signal that ends a motion before its target.

    Attributes:
        signal: monitored signal.
        comparison: how it is compared.
        value: BOOL or REAL with which it is compared; computed when the motion begins.
        timeout: REAL, time after which the motion ends all the same [s]; None for none.
    """

    signal: str
    comparison: Comparison
    value: Expression
    timeout: Expression | None = None


@frozen_dataclass
class Tracking:
    """The signal by which a path is corrected while it is made.

    Attributes:
        signal: measured analog signal.
        value: REAL that it is to have; computed when the motion begins.
        gain: REAL > 0, speed of the correction [m/s] for each unit of the difference.
        direction: of the tool, in which it goes where the signal reads too much.
    """

    signal: str
    value: Expression
    gain: Expression
    direction: ToolDirection


@frozen_dataclass
class Along:
    """A list of poses X_BC through which a motion leads in turn.

    Attributes:
        list: its name.
        count: how many poses it has.
        before: POSE X_AB.
        behind: POSE X_CD; the points are X_AB·X_BC·X_CD.
    """

    list: str
    count: int
    before: Expression
    behind: Expression


@frozen_dataclass
class Move:
    """A motion to a target, through points on the way.

    Attributes:
        kind: how the TCP travels.
        target: POSE in the frame in force or, of PTP, JOINTS.
        settings: hold for this move only.
        span: of the statement.
        via: points on the way. PTP and LIN go from each to the next one and pass them by; one point makes an
            arc, any number a curve.
        angle: REAL [rad], how far an arc goes on its circle instead of ending at the target.
        triggers: outputs that are set on the way.
        guard: condition that ends the motion before its target.
        tracking: correction of the path; None for the planned path.
        along: list whose points the motion leads through, the target being the last one; then `via` is empty,
            and a PTP or LIN goes from each point to the next one. None for none.
        store: variable for the pose that the arm has at the end; empty for none.
    """

    kind: MotionKind
    target: Expression
    settings: Settings
    span: Span
    via: tuple[Expression, ...] = ()
    angle: Expression | None = None
    triggers: tuple[Trigger, ...] = ()
    guard: Guard | None = None
    tracking: Tracking | None = None
    store: str = ""
    along: Along | None = None
