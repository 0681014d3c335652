"""Declarations of a whole text, as the checker of one body sees them."""

from collections.abc import Container, Mapping
from dataclasses import field

from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.flow import PostureRequest
from ropsim.language.check.scope.types import AnyType, Type, Value
from ropsim.language.check.scope.units import UnitSystem
from ropsim.language.environment import Environment, PointTable
from ropsim.program import Block, Expression, Local, SignalUse, Task
from ropsim.spatial import PoseTuple


@frozen_dataclass
class Formal:
    """A parameter of a task.

    Attributes:
        name: of the parameter.
        type: declared, or a cell that the body determines.
        default: value if the call omits it.
        written: the same as the header writes it; empty for tasks of other texts.
    """

    name: str
    type: AnyType
    default: Expression | None = None
    written: str = ""


@frozen_dataclass
class Signature:
    """How a task is called.

    Attributes:
        name: of the task.
        formals: in the order of a call.
        references: names of the formals that are reference locations, first, second …
        result: type of the returned value, or None.
        is_known: false where the header could not be read; then calls are not checked.
    """

    name: str
    formals: tuple[Formal, ...]
    references: tuple[str, ...]
    result: Type | None
    is_known: bool = True


@frozen_dataclass
class Pattern:
    """A grid of locations.

    Attributes:
        counts: columns, rows, layers; 1 where not given.
        origin: first location, in the work frame, or in the one that `moving` names.
        steps: shift per column, row and layer in that frame [m], three vectors.
        order: `row` (a row is filled first), `column` or `snake`.
        external: values of external axes that all locations have [rad | m]; empty for none.
        moving: name of the frame that moves in which it is given, empty for none.
        posture: in which all locations are to be reached, None for any.
        X_KF: frame in whose axes they are shifted.
    """

    counts: tuple[int, int, int]
    origin: PoseTuple
    steps: tuple[tuple[float, float, float], ...]
    order: str
    external: tuple[float, ...] = ()
    moving: str = ""
    posture: PostureRequest | None = None
    X_KF: PoseTuple = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)


@frozen_dataclass
class Written:
    """A number that the text has without a unit; None where it is computed of such."""

    number: float | None = None


@frozen_dataclass
class Reading:
    """A number in SI units: a sensor measures it, `length` or `force`."""

    measure: str


@frozen_dataclass
class OfParameter:
    """A number that callers pass to a parameter."""

    name: str


Origin = Written | Reading | OfParameter
"""Where a plain number comes from."""


@frozen_dataclass
class TaskOrigins:
    """Origins of plain numbers in a task.

    Attributes:
        readings: kind of reading that parameters are compared with, in SI units: `length` or `force`, by
            name.
        result: where its result comes from.
    """

    readings: Mapping[str, str] = field(default_factory=dict)
    result: Origin | None = None


NO_ORIGINS = TaskOrigins()
"""Value of a task without origins."""


@frozen_dataclass
class Variable:
    """Something that can be read, and assigned unless `is_fixed`.

    Attributes:
        name: in the structured program.
        type: known, or a cell that use determines.
        is_fixed: whether it keeps the value assigned by its loop.
        has_counters: whether `.row`, `.col` and `.layer` of it return the place in a pattern.
        origin: where the plain number comes from that it keeps; None where that is not known.
    """

    name: str
    type: AnyType
    is_fixed: bool = False
    has_counters: bool = False
    origin: Origin | None = None


@frozen_dataclass
class Poison:
    """A name whose declaration or first value was wrong: its uses are not reported again."""


@frozen_dataclass
class Listed:
    """A list of points of the project, by its name."""

    name: str
    table: PointTable


Symbol = Variable | Value | SignalUse | Pattern | Listed | Poison


@frozen_dataclass
class World:
    """Declarations outside the bodies that the checker of one body can use.

    Attributes:
        environment: cell and library.
        units: of bare numbers.
        is_strict: whether `strict` stands in the text.
        is_classic: whether tasks without parameter list have implicit ones.
        frame: name of the work frame.
        X_BK: pose of the work frame in the base frame.
        frames: all frames by name, in the base frame.
        tools: all tools by name.
        symbols: constants, locations, variables, signals, patterns and lists seen everywhere.
        has_axes: whether some frame is turned against the work frame or moves, so that locations keep
            along which axes they are shifted.
        signatures: tasks by name.
        without_result: tasks that return a value without its type in the header, reported there.
        joint_count: how many coordinates `joints(…)` has in this text, 0 as long as there is none.
        untyped: variables seen everywhere with types that only use determines.
        own: names of the tasks of the text.
        alike: tasks by name in small letters; tasks of the text first.
        origins: origins of plain numbers in tasks of the text, by name.
    """

    environment: Environment
    units: UnitSystem
    is_strict: bool
    is_classic: bool
    frame: str
    X_BK: PoseTuple
    frames: Mapping[str, PoseTuple]
    tools: Mapping[str, PoseTuple]
    symbols: Mapping[str, Symbol] = field(default_factory=dict)
    has_axes: bool = False
    signatures: Mapping[str, Signature] = field(default_factory=dict)
    without_result: Container[str] = frozenset()
    joint_count: int = 0
    untyped: Container[str] = frozenset()
    own: Container[str] = frozenset()
    alike: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    origins: Mapping[str, TaskOrigins] = field(default_factory=dict)


@frozen_dataclass
class Outcome:
    """A checked body. Places count lines in its unit.

    Attributes:
        block: its statements, as far as they are correct.
        locals: its variables.
        task: the whole task; None for the control statements.
        found: findings, in the order in which they were made.
        unread: hints at variables that nothing reads, reported only if there is no other finding.
        signals: that it names.
        calls: tasks that it calls, and where.
        late: unreachable statements, and the statements before them.
        impossible: arcs and curves whose points make none.
        origins: its origins of plain numbers.
    """

    block: Block
    locals: tuple[Local, ...]
    task: Task | None
    found: tuple[Diagnostic, ...]
    unread: tuple[Diagnostic, ...]
    signals: tuple[SignalUse, ...]
    calls: tuple[tuple[str, Span], ...]
    late: tuple[tuple[Span, Span], ...]
    impossible: tuple[Diagnostic, ...]
    origins: TaskOrigins = NO_ORIGINS
