"""Typed statements of the structured program (SIR): output of front ends and input of posts."""

from ropsim.core import Span, frozen_dataclass
from ropsim.flow import GripAction
from ropsim.program.expressions import Expression
from ropsim.program.move import Move, Settings

Block = tuple["Statement", ...]


@frozen_dataclass
class Grip:
    """Open or close a gripper (empty tool = the tool in force)."""

    action: GripAction
    tool: str
    span: Span


@frozen_dataclass
class Output:
    """Set an output channel."""

    signal: str
    value: Expression
    span: Span


@frozen_dataclass
class Wait:
    """Wait a REAL time [s]."""

    duration: Expression
    span: Span


@frozen_dataclass
class WaitUntil:
    """Wait until a BOOL holds; after `timeout` [s] run `otherwise`, or stop the program where it is empty."""

    condition: Expression
    timeout: Expression | None
    otherwise: Block
    span: Span


@frozen_dataclass
class Assign:
    """Assign a value to a variable."""

    name: str
    value: Expression
    span: Span


@frozen_dataclass
class AssignComponent:
    """Assign a REAL to component `index` of a POSE, VEC or JOINTS variable."""

    name: str
    index: int
    value: Expression
    span: Span


@frozen_dataclass
class Call:
    """Run a task with its arguments in the order of the parameters; `result` names a variable or is empty."""

    task: str
    arguments: tuple[Expression, ...]
    span: Span
    result: str = ""


@frozen_dataclass
class If:
    """The first branch whose condition holds, else `otherwise`; `places` is where each condition stands."""

    branches: tuple[tuple[Expression, Block], ...]
    otherwise: Block
    span: Span
    places: tuple[Span, ...] = ()


@frozen_dataclass
class While:
    """Run while the condition holds."""

    condition: Expression
    body: Block
    span: Span


@frozen_dataclass
class Repeat:
    """Run `count` (INT, evaluated once; None = without end) times, or until `until` holds after a pass.

    `place` is where `until` stands.
    """

    count: Expression | None
    body: Block
    until: Expression | None
    span: Span
    place: Span | None = None


@frozen_dataclass
class For:
    """Run with `variable` from `first` to `last` inclusive by `step` (INT or REAL; a constant, not 0)."""

    variable: str
    first: Expression
    last: Expression
    step: Expression
    body: Block
    span: Span


@frozen_dataclass
class With:
    """Run `body` under `settings`, then restore the earlier settings; tasks called inside inherit them."""

    settings: Settings
    body: Block
    span: Span


@frozen_dataclass
class Set:
    """Change modal values until further notice."""

    settings: Settings
    span: Span


@frozen_dataclass
class Break:
    """Leave the innermost loop."""

    span: Span


@frozen_dataclass
class Continue:
    """Go to the next pass of the innermost loop."""

    span: Span


@frozen_dataclass
class Return:
    """Leave the task."""

    value: Expression | None
    span: Span


@frozen_dataclass
class Stop:
    """End the program."""

    message: str
    span: Span


@frozen_dataclass
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
