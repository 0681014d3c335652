"""Declarations of a text: units, frames, tools, signals, constants, locations, variables, patterns."""

from collections.abc import Container, Iterable
from dataclasses import replace
from types import NoneType

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.icr import Location, composed, external_part, pose_part
from ropsim.language.blocks.matching import Block
from ropsim.language.blocks.units import Part
from ropsim.language.check import grids
from ropsim.language.check.doubts import facing, metres, origins
from ropsim.language.check.expressions import convert, frames, poses, values
from ropsim.language.check.expressions.expression import EXPRESSIONS
from ropsim.language.check.scope import fold, hidden
from ropsim.language.check.scope.body import Body, RejectedError
from ropsim.language.check.scope.types import INT, JOINTS, NAMED, POSE, AnyType, Unknown, Value, closed, known
from ropsim.language.check.scope.units import UNITS, Dimension, UnitSystem
from ropsim.language.check.scope.world import Listed, Origin, Poison, Symbol, Variable, World
from ropsim.language.check.taken_names import TakenNames
from ropsim.language.environment import Environment
from ropsim.language.findings import hidden as hidden_kinds
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.report import Report
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.text import Line
from ropsim.program import SignalUse, ValueType
from ropsim.spatial import PoseTuple, quaternion


@frozen_dataclass
class Declared:
    """Declarations of a text outside its tasks, their errors, and the name of the text."""

    world: World
    found: tuple[Diagnostic, ...]
    name: str = "main"


_TABLES = ("frame", "tool")
_SYMBOLS = ("loc", "signal", "const", "var", "pattern")
"""Words with which declarations begin, by the tables that they extend."""


@frozen_dataclass
class _Tables:
    """Tables of symbols and tools during reading, and the names that are taken."""

    symbols: dict[str, Symbol]
    tools: dict[str, PoseTuple]
    names: TakenNames


def world(
    parts: tuple[Part, ...],
    environment: Environment,
    report: Report,
    tasks: Container[str],
    own: Container[str],
) -> Declared:
    """Return the declarations of a text and its environment; wrong declarations are reported.

    Args:
        parts: of the control statements; at least all possible declarations, and all items up to the first
            one that is none.
        environment: cell and library.
        report: takes findings.
        tasks: names of callable tasks.
        own: names of the tasks of the text.
    """
    names = TakenNames(environment, own)
    top = [
        (part.unit, item)
        for part in parts
        for item in part.items
        if isinstance(item, Line) and item.statement is not None
    ]
    modes = {line.statement.word for _, line in top if isinstance(line.statement, syntax.Mode)}
    named = (line.statement.name.text for _, line in top if isinstance(line.statement, syntax.ProgramHeader))
    title = next(named, None)
    tree = tuple(item for part in parts for item in part.items)
    frames, X_BK, frame = _frames(top, tree, names, report)
    X_KB = quaternion.invert(X_BK)
    has_axes = bool(environment.moving) or any(
        X_BF[3:] != X_BK[3:] for X_BF in (*frames.values(), *environment.given.values(), fold.IDENTITY)
    )
    symbols: dict[str, Symbol] = {name: Listed(name, one) for name, one in environment.lists.items()}
    tools = dict(environment.tools)
    result = World(
        replace(environment, lists={}),  # they stand among the symbols, where each is read by its name
        _units(top, environment),
        "strict" in modes,
        "classic" in modes or not (title is not None or "strict" in modes),
        frame,
        X_BK,
        frames,
        tools,
        symbols,
        has_axes,
    )
    for name, X_BL in environment.locations.items():
        X_KF = quaternion.compose(X_KB, environment.given.get(name, fold.IDENTITY))
        found = _location(environment.located.get(name, ""), X_KB, X_BL, X_KF)
        if name in environment.free:
            found = replace(found, expression=fold.with_free_orientation(found.expression))
        symbols[name] = found
    symbols.update(environment.signals)
    count = _declare_all(result, _Tables(symbols, tools, names), top, report, tasks)
    for name, symbol in symbols.items():
        if isinstance(symbol, Variable):
            symbols[name] = replace(symbol, type=closed(symbol.type))
    return Declared(
        replace(result, joint_count=count), tuple(report.log), title if title is not None else "main"
    )


def may_stand_above(item: Line | Block) -> bool:
    """Return whether the work frame may be set below an item, as only declarations and settings may be."""
    return isinstance(item, Line) and type(item.statement) in _ABOVE


def may_declare(item: Line | Block) -> bool:
    """Return whether an item declares something, was meant to, or sets the frame of declarations below."""
    node = item.statement if isinstance(item, Line) else None
    if isinstance(node, syntax.Broken):
        return node.head in _DECLARING
    return type(node) in _DECLARATIONS or _frame_set(node) is not None


def _frame_set(node: syntax.Statement | None) -> nodes.Name | None:
    """Return the frame that a statement sets for the lines below it; None for any other statement."""
    if isinstance(node, syntax.SetMode) and node.setting.word == "frame":
        return node.setting.name
    return None


def _location(moving: str, X_KB: PoseTuple, pose: Location, X_KF: PoseTuple) -> Value:
    """Return a location of the cell in the work frame, or in the frame `moving` that it is given in."""
    if moving:
        return Value(fold.in_frame(fold.pose(pose), moving), POSE, X_KF=fold.IDENTITY)
    return Value(fold.pose(composed(X_KB, pose)), POSE, X_KF=X_KF)


def _units(top: Iterable[tuple[str, Line]], environment: Environment) -> UnitSystem:
    system = UnitSystem(environment.length, environment.angle)
    for _, line in top:
        if isinstance(line.statement, syntax.Units):
            for name in line.statement.names:
                system = system.using(name.text)
    return system


def _frames(
    top: list[tuple[str, Line]], tree: tuple[Line | Block, ...], names: TakenNames, report: Report
) -> tuple[dict[str, PoseTuple], PoseTuple, str]:
    """Return all frames in the base frame, and pose and name of the work frame.

    The work frame is that of the environment, or of a `set frame` that stands before anything is done: only
    declarations and other `set` statements may come before it. Further down it is lexical, like in a task.
    """
    environment = names.environment
    frames = dict(environment.frames)
    bare = World(
        environment,
        _units(top, environment),
        is_strict=False,
        is_classic=False,
        frame="",
        X_BK=fold.IDENTITY,
        frames=frames,
        tools={},
    )
    for unit, line in top:
        node = line.statement
        if isinstance(node, syntax.FrameDeclaration):
            report.source = unit
            body = Body(bare, report, EXPRESSIONS, None)
            body.line = line
            try:
                names.take(body, node, node.name)
                if node.name.text == "base" and "base" not in environment.frames:
                    hint = "choose another name; the base frame has this one"
                    body.fail(name_kinds.DUPLICATE, node.name, "`base` is the base frame of the robot", hint)
                pose = _constant_pose(body, node.value, "a frame")
                if not _is_given(body, node.name, environment.frames, "frame"):
                    frames[node.name.text] = pose
            except RejectedError:
                frames.setdefault(node.name.text, fold.IDENTITY)
        elif isinstance(node, syntax.Broken) and node.head == "frame" and node.name:
            frames.setdefault(node.name, fold.IDENTITY)
    chosen = environment.frame
    for item in tree:
        if not may_stand_above(item):
            break
        named = _frame_set(item.statement) if isinstance(item, Line) else None
        if named is not None:
            name = named.text
            chosen = name if name in frames else chosen
            chosen = "" if (name == "base" and name not in frames) or name in environment.moving else chosen
            break
    return frames, frames.get(chosen, fold.IDENTITY), chosen if chosen in frames else ""


def _declare_all(
    world: World,
    tables: _Tables,
    top: Iterable[tuple[str, Line]],
    report: Report,
    tasks: Container[str],
) -> int:
    """Enter all declarations; return how many coordinates `joints(…)` has in them."""
    body = Body(world, report, EXPRESSIONS, None)
    body.tasks = tasks
    units: dict[Dimension, str] = {}
    for unit, line in top:
        report.source = unit
        body.line = line
        node = line.statement
        try:
            named = _frame_set(node)
            if named is not None and named.text in (*world.frames, "base"):
                frames.set_frame(body, named)
            elif isinstance(node, syntax.Broken):
                _poison(tables, node)
            elif isinstance(node, syntax.Units):
                _agree(body, node, units)
            elif isinstance(node, syntax.ToolDeclaration):
                tables.tools.setdefault(node.name.text, fold.IDENTITY)
                tables.names.take(body, node, node.name)
                pose = _constant_pose(body, node.value, "a tool")
                if not _is_given(body, node.name, world.environment.tools, "tool"):
                    tables.tools[node.name.text] = pose
                for extra in node.extras:
                    body.warn(
                        kinds.IN_CELL,
                        extra,
                        f"`{extra.text}` of a tool belongs to the cell file",
                        "move it there",
                    )
            elif isinstance(node, syntax.SYMBOLS):
                tables.names.take(body, node, node.name)
                _declare(tables.symbols, body, node)
        except RejectedError:
            continue
    return body.joint_count


def _agree(body: Body, node: syntax.Units, units: dict[Dimension, str]) -> None:
    """Report units of one dimension that differ: a bare number can have only one unit.

    Raises:
        RejectedError: there are such.
    """
    for name in node.names:
        before = units.setdefault(UNITS[name.text][0], name.text)
        if before != name.text:
            message = f"bare numbers are in `{before}` and in `{name.text}`, allowed is one of them"
            body.fail(kinds.TWO_UNITS, name, message, "write the other unit behind the numbers themselves")


def _declare(symbols: dict[str, Symbol], body: Body, node: "_SymbolNode") -> None:
    """Enter a symbol; if the cell has it, the data of the cell hold.

    Raises:
        RejectedError: the declaration is wrong.
    """
    name = node.name.text
    of_cell = symbols.get(name)
    symbols[name] = Poison()
    symbol = _symbol(body, node)
    if isinstance(of_cell, SignalUse) and isinstance(symbol, SignalUse):
        _check_signal(body, node.name, symbol, of_cell)
    elif isinstance(of_cell, Value) and isinstance(node, syntax.LocationDeclaration):
        _is_given(body, node.name, (name,), "location")
        symbol = of_cell
    symbols[name] = symbol


def _check_signal(body: Body, name: nodes.Name, said: SignalUse, of_cell: SignalUse) -> None:
    """Report a signal that differs from the signal of the cell under its name.

    Raises:
        RejectedError: it is another kind of signal.
    """
    if (said.is_input, said.type) != (of_cell.is_input, of_cell.type):
        message = f"`{name.text}` is {hidden.what(of_cell)} of the cell, declared here as {hidden.what(said)}"
        body.fail(
            hidden_kinds.OTHER_SIGNAL, name, message, "declare it as the cell has it, or leave the line out"
        )


def _poison(tables: _Tables, node: syntax.Broken) -> None:
    """Enter the name that a wrong line would have declared, so that its uses are not reported as well."""
    if node.head == "tool" and node.name:
        tables.tools.setdefault(node.name, fold.IDENTITY)
    elif node.head in _SYMBOLS and node.name:
        tables.symbols.setdefault(node.name, Poison())


WITHOUT_CODE = frozenset(syntax.DECLARATIONS) - {syntax.VariableDeclaration}
"""Statements without effect at run time."""
_ABOVE = frozenset({*syntax.DECLARATIONS, syntax.SetMode, NoneType})
_DECLARATIONS = frozenset(syntax.DECLARATIONS)
_DECLARING = frozenset({*_TABLES, *_SYMBOLS})
_SymbolNode = (
    syntax.LocationDeclaration
    | syntax.SignalDeclaration
    | syntax.ConstantDeclaration
    | syntax.VariableDeclaration
    | syntax.PatternDeclaration
)


def _symbol(body: Body, node: _SymbolNode) -> Symbol:
    match node:
        case syntax.LocationDeclaration():
            value = values.check(body, node.value)
            facing.check_target(body, node.value)
            if known(value.type) not in (POSE, JOINTS):
                convert.to(body, value, POSE, node.value, "the value of a location")
            return _fixed(body, value, node.value, "a location")
        case syntax.SignalDeclaration():
            values.expect(body, node.channel, INT, "the channel of a signal")
            return SignalUse(
                node.name.text, node.is_input, ValueType.REAL if node.is_analog else ValueType.BOOL
            )
        case syntax.ConstantDeclaration():
            value = values.check(body, node.value)
            if node.type is not None:
                wanted = NAMED[node.type.text]
                expression = convert.to(body, value, wanted, node.value, f"the value of `{node.name.text}`")
                value = Value(expression, wanted, is_bare=wanted == INT)
            return _fixed(body, value, node.value, "a constant")
        case syntax.VariableDeclaration():
            variable = Variable(node.name.text, _variable_type(body, node))
            return (
                replace(variable, origin=_first_origin(body, node))
                if origins.is_number(variable)
                else variable
            )
    return grids.pattern(body, node)


def _fixed(body: Body, value: Value, node: nodes.Node, what: str) -> Value:
    inner, posture, moving = fold.opened(value.expression)
    numbers = convert.constant(body, inner, node, what)
    return Value(fold.closed(numbers, posture, moving), value.type, value.is_bare, value.X_KF)


def _first_origin(body: Body, node: syntax.VariableDeclaration) -> Origin | None:
    """Return where the plain number comes from that a variable has first."""
    if node.value is None or not origins.has_sensors(body.world):
        return None
    return origins.origin_of(body, values.check(body, node.value).expression)


def _variable_type(body: Body, node: syntax.VariableDeclaration) -> AnyType:
    if node.type is not None:
        return NAMED[node.type.text]
    if node.value is None:
        return Unknown()
    value = values.check(body, node.value)
    return Unknown() if value.is_bare and body.world.is_classic else value.type


def _constant_pose(body: Body, node: nodes.Node, what: str, X_BC: PoseTuple = fold.IDENTITY) -> PoseTuple:
    """Return the pose of a frame or a tool; `X_BC` is the frame of the room in which it is given."""
    if isinstance(node, nodes.Rebase):
        X_KF, moving = body.frame(node.frame)
        if moving:
            message = f"{what} cannot be given in `{moving}`, which an external axis moves"
            hint = "describe it in the cell file, with the same `parent`"
            body.fail(name_kinds.FRAME_MOVES, node.frame, message, hint)
        return quaternion.compose(
            X_KF, _constant_pose(body, node.operand, what, quaternion.compose(X_BC, X_KF))
        )
    value = fold.location_of(convert.constant(body, poses.transform(body, node, X_BC), node, what))
    assert value is not None
    metres.check_frame(body, node)
    if external_part(value):
        hint = "locations have them: leave them out here"
        body.fail(kinds.WRONG_TYPE, node, f"{what} has no values of external axes", hint)
    return pose_part(value)


def _is_given(body: Body, name: nodes.Name, given: Container[str], what: str) -> bool:
    """Return whether the cell defines a frame, tool or location of that name; its calibrated pose holds."""
    if name.text not in given:
        return False
    body.warn(
        name_kinds.GIVEN_BY_CELL,
        name,
        f"{what} `{name.text}` is defined by the cell, whose pose is used",
        f"remove this line, or give the {what} another name",
    )
    return True
