"""Typed statements of the structured program (SIR): what front ends produce and posts print."""

from dataclasses import dataclass

from ropsim.core import Span
from ropsim.flow import Comparison, GripAction, MotionKind, Side
from ropsim.program.expressions import Expression

Block = tuple["Statement", ...]


@dataclass(frozen=True, slots=True)
class Settings:
    """Modal values to set; None leaves a value as it is.

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
        return self == Settings()


@dataclass(frozen=True, slots=True)
class Trigger:
    """An output that is set at a place of a motion.

    Attributes:
        signal: the output.
        value: what it is set to.
        side: end of the motion from which is counted.
        distance: REAL, way of the TCP from there [m]; None where a time is given.
        time: REAL, time from there [s]; None where a distance is given.
    """

    signal: str
    value: Expression
    side: Side
    distance: Expression | None = None
    time: Expression | None = None


@dataclass(frozen=True, slots=True)
class Guard:
    """The condition on one signal that ends a motion before its target.

    Attributes:
        signal: what is looked at.
        comparison: how it is compared.
        value: BOOL or REAL with which it is compared; computed when the motion begins.
        timeout: REAL, time after which the motion ends all the same [s]; None for none.
    """

    signal: str
    comparison: Comparison
    value: Expression
    timeout: Expression | None = None


@dataclass(frozen=True, slots=True)
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
        guard: what ends the motion before its target.
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
    store: str = ""


@dataclass(frozen=True, slots=True)
class Grip:
    """Open or close a gripper (empty tool = the tool in force)."""

    action: GripAction
    tool: str
    span: Span


@dataclass(frozen=True, slots=True)
class Output:
    """Set an output channel."""

    signal: str
    value: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class Wait:
    """Wait a REAL time [s]."""

    duration: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class WaitUntil:
    """Wait until a BOOL holds; after `timeout` [s] run `otherwise`, or stop the program where it is empty."""

    condition: Expression
    timeout: Expression | None
    otherwise: Block
    span: Span


@dataclass(frozen=True, slots=True)
class Assign:
    """Give a variable a value."""

    name: str
    value: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class AssignComponent:
    """Give component `index` of a POSE, VEC or JOINTS variable a REAL."""

    name: str
    index: int
    value: Expression
    span: Span


@dataclass(frozen=True, slots=True)
class Call:
    """Run a task with its arguments in the order of the parameters; `result` names a variable or is empty."""

    task: str
    arguments: tuple[Expression, ...]
    span: Span
    result: str = ""


@dataclass(frozen=True, slots=True)
class If:
    """The first branch whose condition holds, else `otherwise`."""

    branches: tuple[tuple[Expression, Block], ...]
    otherwise: Block
    span: Span


@dataclass(frozen=True, slots=True)
class While:
    """Run while the condition holds."""

    condition: Expression
    body: Block
    span: Span


@dataclass(frozen=True, slots=True)
class Repeat:
    """Run `count` (INT, evaluated once; None = without end) times, or until `until` holds after a pass."""

    count: Expression | None
    body: Block
    until: Expression | None
    span: Span


@dataclass(frozen=True, slots=True)
class For:
    """Run with `variable` from `first` to `last` inclusive by `step` (INT or REAL; a constant, not 0)."""

    variable: str
    first: Expression
    last: Expression
    step: Expression
    body: Block
    span: Span


@dataclass(frozen=True, slots=True)
class With:
    """Run `body` under `settings`, then restore what held before; tasks called inside inherit them."""

    settings: Settings
    body: Block
    span: Span


@dataclass(frozen=True, slots=True)
class Set:
    """Change modal values until further notice."""

    settings: Settings
    span: Span


@dataclass(frozen=True, slots=True)
class Break:
    """Leave the innermost loop."""

    span: Span


@dataclass(frozen=True, slots=True)
class Continue:
    """Go to the next pass of the innermost loop."""

    span: Span


@dataclass(frozen=True, slots=True)
class Return:
    """Leave the task."""

    value: Expression | None
    span: Span


@dataclass(frozen=True, slots=True)
class Stop:
    """End the program."""

    message: str
    span: Span


@dataclass(frozen=True, slots=True)
class Message:
    """Show the values, joined by blanks."""

    parts: tuple[Expression, ...]
    span: Span


Statement = (
    Move
    | Grip
    | Output
    | Wait
    | WaitUntil
    | Assign
    | AssignComponent
    | Call
    | If
    | While
    | Repeat
    | For
    | With
    | Set
    | Break
    | Continue
    | Return
    | Stop
    | Message
)
