"""The state of the checker while it walks through one body: a task or the control statements."""

from collections.abc import Callable, Container, Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, NoReturn

from ropsim.core import Diagnostic, Kind, Span, did_you_mean, frozen_dataclass, maker, there_are
from ropsim.language.check.scope.fold import IDENTITY
from ropsim.language.check.scope.in_force import FrameInForce
from ropsim.language.check.scope.sight import NOTHING_BEFORE, Sight
from ropsim.language.check.scope.table import Table
from ropsim.language.check.scope.types import AnyType, Type, Unknown, Value, known
from ropsim.language.check.scope.world import Listed, OfParameter, Origin, Poison, Symbol, Variable, World
from ropsim.language.findings import names as kinds
from ropsim.language.report import Placed, Report
from ropsim.language.syntax.nodes import Name
from ropsim.language.syntax.text import Line
from ropsim.program import Local, SignalUse, ValueType
from ropsim.spatial import PoseTuple, quaternion

_variable, _local = maker(Variable), maker(Local)


class RejectedError(Exception):
    """The statement is wrong and has been reported; it is left out, the next one goes on."""


@frozen_dataclass
class Loop:
    """An open loop.

    Attributes:
        flag: the variable that a `break` must set, because the loop is nested in itself.
        variable: the variable of the loop, empty for none.
    """

    flag: str = ""
    variable: str = ""


@frozen_dataclass
class Made:
    """Where a variable has its first value: unit, line, place of the name, and that in the program."""

    unit: str
    line: Line
    place: Name
    variable: str


@frozen_dataclass
class Unfit:
    """A value that a variable cannot keep because of its first value.

    Attributes:
        finding: the finding without the first value.
        variable: its name in the structured program.
        kind: of the value.
        unit: in which the text has values of this kind, empty where that has no name.
        is_bare: whether the value takes the unit of the place where it stands.
    """

    finding: Diagnostic
    variable: str
    kind: Type
    unit: str
    is_bare: bool


Expressions = Mapping[type, Callable[["Body", Any], Value]]
"""How each kind of expression node is checked."""

Told = Callable[[str, AnyType | None], AnyType | None]
"""Type of a new variable, by its name and its first assignment; None keeps the type of the assignment."""


class Body:
    """Names, frame and loops in force, and where findings go.

    Attributes:
        world: declarations of the text.
        report: where findings go.
        expressions: how each kind of expression is checked.
        names: meanings of the names of this body at the present line.
        variables: all parameters and variables, by the names that they have in the structured program.
        past: names of loop variables whose loop has ended.
        references: reference locations of the task, first, second …
        tasks: names of callable tasks without a signature in `world`.
        result: type of the value to return, or None.
        task: name of the task, empty for the control statements.
        line: the line in hand.
        in_force: the frame in which locations are read.
        ended: name of a frame that was set in a block that has ended, while no location was read since.
        each: list whose points a motion or loop takes in turn, in the expression in hand; None for none.
        loops: open loops, innermost last.
        depth: nesting of the lines in hand; 1 outside all blocks.
        is_tolerant: unknown names are not reported (the header of the task could not be read).
        sight: context of this part of a body.
        read_all_names: whether all names were requested and `sight` did not contain them.
        made: variables that an assignment made, and where.
        declared: variables of all tasks that lines of this part declare by their first values, and where.
        unfit: values that do not fit first values.
        looked_through: the last line that was searched for a long length, and the result.
        quantities: variables with whole numbers that stand in place of a quantity, each with its unit.
        read: names of the variables that are read.
        readings: kind of reading that parameters are compared with, in SI units: `length` or `force`, by
            name.
        returned: where the results come from that it returns.
        counted: variables whose plain numbers are compared with readings.
        used_signals: signals that are named.
        joint_count: how many coordinates `joints(…)` has, 0 as long as there is none.
        lacks_result: whether a value is returned and the header has no type for it.
        has_gaps: a line that may have been a way out is wrong and left out; a missing `return` is not
            reported then.
    """

    def __init__(
        self,
        world: World,
        report: Report,
        expressions: Expressions,
        told: Told | None,
        task: str = "",
        sight: Sight = NOTHING_BEFORE,
    ) -> None:
        self.world = world
        self.report = report
        self.expressions = expressions
        self.sight = sight
        self.read_all_names = False
        self.names: dict[str, Symbol] = sight.symbols()
        self.variables: dict[str, Variable] = {}
        self.past = {name for name, one in sight.names.items() if one.is_past}
        self.numbers = {name: one.number for name, one in sight.names.items()}
        self.references: tuple[str, ...] = ()
        self.tasks: Container[str] = ()
        self.result: Type | None = None
        self.task = task
        self.line = Line.empty()
        self.looked_through = self.line, False
        self.in_force = FrameInForce(sight.X_KC, sight.moving)
        self.ended = sight.ended
        self.each: Listed | None = None
        self.loops: list[Loop] = []
        self.depth = 0
        self.is_tolerant = False
        self.has_gaps = False
        self.made: dict[str, Made] = {}
        self.declared: dict[str, Made] = {}
        self.unfit: list[Unfit] = []
        self.quantities: set[tuple[str, str]] = set()
        self.read: set[str] = set()
        self.readings: dict[str, str] = {}
        self.returned: list[Origin | None] = []
        self.counted: set[str] = set()
        self.used_signals: dict[str, SignalUse] = {}
        self.joint_count = sight.joint_count or world.joint_count
        self.lacks_result = False
        self._told = told
        self._declared_names: tuple[str, ...] | None = None
        self._truth_signals: frozenset[str] | None = None

    # --- findings

    def span(self, place: Placed) -> Span:
        """Return where a node stands."""
        return self.line.logical.span(self.report.source, place.start, place.end)

    @property
    def statement_span(self) -> Span:
        """Return where the statement in hand stands."""
        line = self.line
        place = line.statement or line
        return line.logical.span(self.report.source, place.start, place.end)

    def warn(self, kind: Kind, place: Placed, message: str, hint: str = "", fix: str | None = None) -> None:
        """Report a finding and go on."""
        self.report.at(kind, self.line, place, message, hint, fix=fix)

    def written(self, place: Placed) -> str:
        """Return the text of a node of the line in hand."""
        return self.line.logical.text[place.start : place.end]

    def fail(
        self, kind: Kind, place: Placed, message: str, hint: str = "", fix: str | None = None
    ) -> NoReturn:
        """Report a finding and abandon the statement.

        Raises:
            RejectedError: always.
        """
        self.report.at(kind, self.line, place, message, hint, fix=fix)
        raise RejectedError

    def reject(self, finding: Diagnostic) -> NoReturn:
        """Report a finding of another module and abandon the statement.

        Raises:
            RejectedError: always.
        """
        if not self.report.muted:
            self.report.add(finding)
        raise RejectedError

    # --- names

    def find(self, name: str) -> Symbol | None:
        """Return the meaning of a name here."""
        return self.names.get(name) or self.world.symbols.get(name)

    def visible(self) -> dict[str, Symbol | None]:
        """Return all visible names except those declared or of the cell; None for names of earlier parts."""
        if self.sight.around is None:
            self.read_all_names = True
        return {**dict.fromkeys(self.sight.around or ()), **self.names}

    def declared_names(self) -> tuple[str, ...]:
        """Return the names of all declarations that may be used; each table is traversed once."""
        if self._declared_names is not None:
            return self._declared_names
        symbols = self.world.symbols
        found = tuple(
            name for name, one in symbols.items() if not isinstance(one, Poison) and "__" not in name
        )
        if isinstance(symbols, Table):  # others grow while declarations are read
            self._declared_names = found
        return found

    def with_points(self, listed: Listed, name: Name) -> Listed:
        """Return a list that can be used.

        Raises:
            RejectedError: its text is wrong, which is reported there.
        """
        if not listed.table.points:
            message = f"the list of points `{listed.name}` cannot be used: its text is wrong"
            source = listed.table.source
            self.fail(kinds.UNKNOWN_LIST, name, message, f"mend `{source}`" if source else "mend it")
        return listed

    def truth_signals(self) -> frozenset[str]:
        """Return the names of all signals that are on or off."""
        if self._truth_signals is None:
            found = ((name, self.world.symbols.get(name)) for name in self.declared_names())
            self._truth_signals = frozenset(
                name for name, one in found if isinstance(one, SignalUse) and one.type is ValueType.BOOL
            )
        return self._truth_signals

    def enter(self, name: str, kind: AnyType) -> None:
        """Enter a parameter."""
        origin = OfParameter(name)
        self.names[name] = self.variables[name] = _variable(
            name, kind, is_fixed=False, has_counters=False, origin=origin
        )

    def declare(self, name: str, kind: AnyType | None = None) -> Variable:
        """Enter a variable of this body; without `kind` it has the type found by the inference pass."""
        variable = self._made(self._free(name), kind)
        self.names[name] = variable
        return variable

    def loop_variable(self, name: str, kind: AnyType) -> Variable:
        """Return a variable of one loop; `with_name` lets the lines of the loop see it."""
        return self._made(self._free(name), kind)

    def hidden(self, name: str, kind: Type) -> Variable:
        """Return a variable for internal data of the compiler, always the same one.

        A name with a dot is one that no program can write.
        """
        return self.variables.get(name) or self._made(name, kind)

    def _made(self, name: str, kind: AnyType | None) -> Variable:
        if self._told is not None:
            kind = self._told(name, kind)
        kind = kind if kind is not None else Unknown()
        variable = self.variables[name] = _variable(
            name, kind, is_fixed=False, has_counters=False, origin=None
        )
        return variable

    def _free(self, name: str) -> str:
        """Return a name that no other variable in sight has in the structured program."""
        number = self.numbers.get(name, 0) + 1
        chosen = name if number == 1 else f"{name}.{number}"
        while chosen in self.variables or isinstance(self.world.symbols.get(chosen), Variable):
            number += 1
            chosen = f"{name}.{number}"
        self.numbers[name] = number
        return chosen

    def poison(self, name: str) -> None:
        """Enter a name whose uses are not to be reported, unless it has a meaning already."""
        if self.find(name) is None:
            self.names[name] = Poison()

    def frame(self, name: Name) -> tuple[PoseTuple, str]:
        """Return X_KF of a frame by name; of one that moves the identity, and its name.

        Raises:
            RejectedError: the frame is unknown.
        """
        if name.text in self.world.environment.moving:
            return IDENTITY, name.text
        if self.world.frame and name.text == self.world.frame:
            return IDENTITY, ""
        frames = self.world.frames
        if name.text == "base" and "base" not in frames:
            return quaternion.invert(self.world.X_BK), ""
        if name.text not in frames:
            self.unknown(kinds.UNKNOWN_FRAME, name, "frame", (*frames, "base"))
        return quaternion.compose(quaternion.invert(self.world.X_BK), frames[name.text]), ""

    def tool(self, name: Name) -> str:
        """Return the name of a tool that exists.

        Raises:
            RejectedError: the tool is unknown.
        """
        if name.text not in self.world.tools:
            self._refuse_tool_of_others(name)
            self.unknown(kinds.UNKNOWN_TOOL, name, "tool", self.world.tools)
        return name.text

    def _refuse_tool_of_others(self, name: Name) -> None:
        """Report a tool that the cell has and the station of this program has not.

        Raises:
            RejectedError: the tool is of this kind.
        """
        environment = self.world.environment
        if name.text in environment.others_tools:
            own = ", ".join(f'"{one}"' for one in (*environment.tools, name.text))
            message = f"the station does not have the tool `{name.text}` of this cell"
            hint = f"give it to the station in the cell file: `tools = [{own}]`"
            self.fail(kinds.UNKNOWN_TOOL, name, message, hint)

    def unknown(self, kind: Kind, name: Name, what: str, candidates: Iterable[str]) -> NoReturn:
        """Report an unknown name, with the nearest known one.

        Raises:
            RejectedError: always.
        """
        if self.report.muted:  # without a reader the search for near names is skipped
            raise RejectedError
        known_names = sorted(candidates)
        hint = did_you_mean(name.text, known_names)
        fix = hint.split("`")[1] if hint else None
        if not hint:
            hint = there_are(known_names[:8]) or f"no {what} is defined"
        self.fail(kind, name, f"there is no {what} `{name.text}`", hint, fix=fix)

    # --- scopes

    @contextmanager
    def with_name(self, name: str, symbol: Symbol) -> Iterator[None]:
        """Let a name mean a loop variable within the block, regardless of its outer meaning."""
        before = self.names.get(name)
        self.names[name] = symbol
        try:
            yield
        finally:
            del self.names[name]
            if before is not None:
                self.names[name] = before
            self.past.add(name)

    @contextmanager
    def in_loop(self, loop: Loop) -> Iterator[None]:
        """Allow `break` and `continue` for a while."""
        self.loops.append(loop)
        try:
            yield
        finally:
            self.loops.pop()

    def locals(self, parameters: tuple[str, ...]) -> tuple[Local, ...]:
        """Return the variables other than `parameters`, with final types, in the order they came to be."""
        return tuple(
            _local(symbol.name, settled(symbol.type).value)
            for symbol in self.variables.values()
            if symbol.name not in parameters
        )

    def types(self) -> dict[str, Type]:
        """Return the final type of every variable."""
        return {name: settled(variable.type) for name, variable in self.variables.items()}


def settled(kind: AnyType) -> Type:
    """Return the final type: as found, or the default of an unknown one."""
    found = known(kind)
    return found if isinstance(found, Type) else found.settle()
