"""A part of the control statements alone: its findings, and its effect on the parts behind it."""

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace

from ropsim.core import Diagnostic, Span, frozen_dataclass, maker
from ropsim.language.blocks.units import Part
from ropsim.language.check.expressions.expression import EXPRESSIONS
from ropsim.language.check.reached import goes_on, late
from ropsim.language.check.scope.body import Body, Made, Unfit, settled
from ropsim.language.check.scope.sight import Seen, Sight
from ropsim.language.check.scope.types import OPEN, AnyType, Type, Unknown, known
from ropsim.language.check.scope.world import Symbol, Variable, World
from ropsim.language.check.statements import structures
from ropsim.language.report import Report, TooManyFindingsError
from ropsim.program import Block, Call, Local, SignalUse, walk
from ropsim.spatial import PoseTuple


@frozen_dataclass
class Open:
    """A type that only use determines.

    Attributes:
        name: of the first variable that has it.
        has_number: whether a number was seen.
        has_fraction: whether one with a fraction was seen.
    """

    name: str
    has_number: bool
    has_fraction: bool

    @property
    def settled(self) -> Type:
        """Return the default of the type."""
        return Unknown(has_number=self.has_number, has_fraction=self.has_fraction).settle()


AnyState = Type | Open
_seen = maker(Seen)


@frozen_dataclass
class Left:
    """Effect of a part on the parts behind it.

    Attributes:
        names: changed meanings of names.
        X_KC: frame of literals, in the work frame; the identity where that frame moves.
        moving: name of the frame of literals where it moves, empty where it stands still.
        joint_count: how many coordinates `joints(…)` has, 0 as long as there is none.
        ended: name of a frame that was set in a block that has ended, while no location was read since.
    """

    names: Mapping[str, Seen]
    X_KC: PoseTuple
    moving: str
    joint_count: int
    ended: str


@frozen_dataclass
class InferredPart:
    """Result of the inference pass for a part.

    Attributes:
        left: to the parts behind it.
        types: of the variables that it makes.
        told: evidence for open types of variables made before, by their names.
    """

    left: Left
    types: Mapping[str, AnyState]
    told: Mapping[str, AnyState]


@frozen_dataclass
class CheckedPart:
    """A checked part. Places count lines in its unit.

    Attributes:
        left: to the parts behind it.
        block: its statements, as far as they are correct.
        locals: variables that it makes.
        found: findings, in the order in which they were made.
        made: variables that an assignment made, and where.
        declared: variables of all tasks that it declares by their first values, and where.
        unfit: values among the findings that do not fit first values.
        quantities: variables with whole numbers that stand in place of a quantity, with its unit.
        read: names of the variables that are read.
        signals: that it names.
        calls: tasks that it calls, and where.
        late: unreachable statements, and the statements before them.
        end: number of the first statement that does not go on, None where all do.
        read_all_names: whether the names of all variables before it may be needed for it.
    """

    left: Left
    block: Block
    locals: tuple[Local, ...]
    found: tuple[Diagnostic, ...]
    made: Mapping[str, Made]
    declared: Mapping[str, Made]
    unfit: tuple[Unfit, ...]
    quantities: frozenset[tuple[str, str]]
    read: frozenset[str]
    signals: tuple[SignalUse, ...]
    calls: tuple[tuple[str, Span], ...]
    late: tuple[tuple[Span, Span], ...]
    end: int | None
    read_all_names: bool


@frozen_dataclass
class PartAlone:
    """A part that depends on no type inferred elsewhere: one pass finds its types and its errors."""

    walked: InferredPart
    checked: CheckedPart


class InferredElsewhereError(Exception):
    """The type of a variable is not determined where the part makes it."""


def inferred_part(world: World, part: Part, sight: Sight, states: Mapping[str, AnyState]) -> InferredPart:
    """Return the inference results of a part.

    Args:
        world: declarations of the text.
        part: of the control statements.
        sight: context before it; all its open types are `OPEN`.
        states: of those variables.
    """
    report = Report(part.unit)
    report.muted = True
    cells: dict[str, Unknown] = {}
    names = {
        name: replace(one, symbol=_opened(one.symbol, states, cells)) for name, one in sight.names.items()
    }
    inner = replace(sight, names=names)
    body = Body(world, report, EXPRESSIONS, None, sight=inner)
    structures.walk_part(body, part.items)
    firsts = {id(cell.root()): name for name, cell in reversed(cells.items())}
    types = {name: _state(name, one, firsts) for name, one in body.variables.items()}
    told = {name: _state(name, Variable(name, cell), firsts) for name, cell in cells.items()}
    return InferredPart(_left(body, inner), types, told)


def checked_part(world: World, part: Part, sight: Sight, types: Mapping[str, Type]) -> CheckedPart:
    """Return a part, checked; `types` are the types of the variables that it makes."""
    return _checked(Body(world, Report(part.unit), EXPRESSIONS, types.get, sight=sight), part)


def part_alone(world: World, part: Part, sight: Sight) -> PartAlone | None:
    """Return a part whose variables have their types at their first assignment; None for any other.

    Args:
        world: declarations of the text; it raises `InferredElsewhereError` if a type depends on other bodies.
        part: of the control statements.
        sight: context before it, without open types.
    """
    body = Body(world, Report(part.unit), EXPRESSIONS, _at_once, sight=sight)
    try:
        checked = _checked(body, part)
    except InferredElsewhereError:
        return None
    types = {name: settled(one.type) for name, one in body.variables.items()}
    return PartAlone(InferredPart(checked.left, types, {}), checked)


def _at_once(_: str, kind: AnyType | None) -> Type:
    """Return the type with which a variable is made.

    Raises:
        InferredElsewhereError: only later use determines the type.
    """
    if isinstance(kind, Type):
        return kind
    raise InferredElsewhereError


def _checked(body: Body, part: Part) -> CheckedPart:
    report, sight = body.report, body.sight
    block: Block = ()
    with suppress(TooManyFindingsError):  # the list of the whole text will be full as well
        block = structures.walk_part(body, part.items)
    return CheckedPart(
        _left(body, sight),
        block,
        body.locals(()),
        tuple(report.log),
        body.made,
        body.declared,
        tuple(body.unfit),
        frozenset(body.quantities),
        frozenset(body.read),
        tuple(body.used_signals.values()),
        tuple((one.task, one.span) for one in walk(block) if isinstance(one, Call)),
        tuple(late(block)),
        next((number for number, statement in enumerate(block) if not goes_on(statement)), None),
        body.read_all_names,
    )


def _opened(
    symbol: Symbol | None, states: Mapping[str, AnyState], cells: dict[str, Unknown]
) -> Symbol | None:
    """Return the meaning of a name, its open type in a cell of its own that variables of one type share."""
    if not isinstance(symbol, Variable) or symbol.type is not OPEN:
        return symbol
    state = states[symbol.name]
    if isinstance(state, Type):
        return replace(symbol, type=state)
    cell = cells.setdefault(state.name, Unknown(has_number=state.has_number, has_fraction=state.has_fraction))
    return replace(symbol, type=cell)


def _state(name: str, variable: Variable, firsts: dict[int, str]) -> AnyState:
    """Return the type of a variable, or the evidence for it."""
    found = known(variable.type)
    if isinstance(found, Type):
        return found
    return Open(firsts.setdefault(id(found), name), found.has_number, found.has_fraction)


def _left(body: Body, sight: Sight) -> Left:
    return Left(
        dict(_changed(body, sight)), body.in_force.X_KC, body.in_force.moving, body.joint_count, body.ended
    )


def _changed(body: Body, sight: Sight) -> Iterator[tuple[str, Seen]]:
    """Yield the names with changed meaning."""
    for name in dict.fromkeys((*body.names, *body.numbers, *body.past)):
        symbol, number, is_past = body.names.get(name), body.numbers.get(name, 0), name in body.past
        before = sight.names.get(name)
        if (
            before is None
            or before.symbol is not symbol
            or before.number != number
            or before.is_past != is_past
        ):
            yield name, _seen(_closed(symbol), number, is_past)


def _closed(symbol: Symbol | None) -> Symbol | None:
    if not isinstance(symbol, Variable) or isinstance(symbol.type, Type):
        return symbol
    found = known(symbol.type)
    return replace(symbol, type=found if isinstance(found, Type) else OPEN)
