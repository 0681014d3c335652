"""Loops: `repeat`, `while`, `for` and `for each`."""

from collections.abc import Callable
from dataclasses import replace

from ropsim.language.check.expressions import convert, frames, poses, values
from ropsim.language.check.scope import fold, hidden
from ropsim.language.check.scope.body import Body, Loop, RejectedError
from ropsim.language.check.scope.types import BOOL, INT, POSE, AnyType, Type, article, known
from ropsim.language.check.scope.world import Listed, Pattern, Poison, Variable
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.nodes import Name
from ropsim.program import (
    Assign,
    Binary,
    Block,
    Break,
    Constant,
    Expression,
    For,
    If,
    ValueType,
    While,
)
from ropsim.program import Variable as VariableExpression

Walk = Callable[[], Block]

_INT, _REAL = ValueType.INT, ValueType.REAL


def count_of(body: Body, node: syntax.Repeat) -> Expression | None:
    """Return the count of `repeat`, None without one."""
    return None if node.count is None else values.expect(body, node.count, INT, "the count of `repeat`")


def while_condition(body: Body, node: syntax.While) -> Expression:
    """Return the condition of `while`."""
    return values.expect(body, node.condition, BOOL, "the condition of `while`")


def while_loop(body: Body, condition: Expression, inner: Block) -> Block:
    """Return a loop with its condition before each pass."""
    return (While(condition, inner, body.statement_span),)


def for_header(body: Body, node: syntax.For) -> tuple[Variable, Expression, Expression, Expression]:
    """Return variable, first, last and step of `for`.

    A variable that has the name already is given the values, unless it is that of a loop around: else it is
    one of this loop alone.
    """
    first, last = values.check(body, node.first), values.check(body, node.last)
    step = values.check(body, node.step) if node.step is not None else None
    given = [v for v in (first, last, step) if v is not None]
    kind: AnyType = INT
    for value in given:
        found = known(value.type)
        if not value.is_bare:
            kind = found
            break
        if found != INT:
            kind = found
    symbol = body.find(node.name.text)
    around = {loop.variable for loop in body.loops}
    if isinstance(symbol, Variable) and symbol.name not in around:
        variable = symbol
    else:
        _refuse_declared(body, node.name)
        variable = body.loop_variable(node.name.text, kind)
    low = convert.to(body, first, variable.type, node.first, "the first value of `for`")
    high = convert.to(body, last, variable.type, node.last, "the last value of `for`")
    if step is None or node.step is None:
        found = known(variable.type)
        is_whole = not isinstance(found, Type) or found.value is _INT
        if not is_whole:
            body.fail(
                kinds.ARGUMENTS,
                node,
                f"`for` over {article(found)} needs a `step`",
                "write `step` and a constant",
            )
        return variable, low, high, fold.whole(1)
    way = convert.to(body, step, variable.type, node.step, "the step of `for`")
    if convert.constant(body, way, node.step, "the step of `for`").value == 0:
        body.fail(kinds.OUT_OF_RANGE, node.step, "the step of `for` must not be zero")
    return variable, low, high, way


def _refuse_declared(body: Body, name: Name) -> None:
    """Report a loop variable with the name of something that is declared.

    Raises:
        RejectedError: the name is taken.
    """
    taken = hidden.declared_as(body.world, name.text)
    if taken:
        message = f"`{name.text}` cannot be a loop variable: it is {taken}"
        body.fail(name_kinds.NOT_ASSIGNABLE, name, message, "choose another name")


def for_each(body: Body, node: syntax.ForEach, walk: Walk) -> Block:
    """Return nested loops over layers, rows and columns of a pattern.

    The body sees `name` (the location) and `name.row`, `name.col`, `name.layer`, counted from 1; they are
    variables of this loop alone, regardless of the outer meaning of `name`.

    Raises:
        RejectedError: the pattern is unknown.
    """
    pattern = body.find(node.pattern.text)
    if isinstance(pattern, Poison):
        raise RejectedError
    if isinstance(pattern, Listed):
        return _over_list(body, node, body.with_points(pattern, node.pattern), walk)
    if not isinstance(pattern, Pattern):
        places = [n for n, s in body.world.symbols.items() if isinstance(s, Pattern | Listed)]
        body.unknown(name_kinds.UNKNOWN_PATTERN, node.pattern, "pattern or list of points", places)
    name = node.name.text
    _refuse_declared(body, node.name)
    variable = replace(body.loop_variable(name, POSE), is_fixed=True, has_counters=True)
    for counter in ("row", "col", "layer", "pass", "line"):
        body.hidden(f"{variable.name}.{counter}", INT)
    flag = f"{variable.name}.left"
    with body.with_name(name, variable), body.in_loop(Loop(flag, variable.name)):
        inner = walk()
    nest = _Nest(body, variable.name, pattern, flag if _uses(inner, flag) else "")
    return nest.block(inner)


def _over_list(body: Body, node: syntax.ForEach, listed: Listed, walk: Walk) -> Block:
    """Return a loop over the points of a list, which are read in the frame in force at its header."""
    _refuse_declared(body, node.name)
    variable = replace(body.loop_variable(node.name.text, POSE), is_fixed=True)
    number = body.hidden(f"{variable.name}.number", INT)
    span = body.statement_span
    point = frames.listed_point(body, listed, VariableExpression(number.name, _INT))
    with body.with_name(node.name.text, variable), body.in_loop(Loop("", variable.name)):
        inner = walk()
    assign = Assign(variable.name, poses.kept(point, point.expression), span)
    last = fold.whole(len(listed.table.points))
    return (For(number.name, fold.whole(1), last, fold.whole(1), (assign, *inner), span),)


class _Nest:
    """Builds the loops of one `for each`."""

    def __init__(self, body: Body, name: str, pattern: Pattern, flag: str) -> None:
        self.span = body.statement_span
        self.name = name
        self.pattern = pattern
        self.flag = flag
        if flag:
            body.hidden(flag, BOOL)
        columns, rows, layers = pattern.counts
        self.counts = {"col": columns, "row": rows, "layer": layers}

    def block(self, inner: Block) -> Block:
        """Return the assignments and loops around the body."""
        placed = (Assign(self.name, self._location(), self.span), *inner)
        if self.pattern.order == "snake":
            block = self._snake(placed)
        else:
            fast, slow = ("row", "col") if self.pattern.order == "column" else ("col", "row")
            block = self._loop("layer", self._loop(slow, self._loop(fast, placed)))
        start = (Assign(self.flag, fold.FALSE, self.span),) if self.flag else ()
        return (*start, *block)

    def _snake(self, placed: Block) -> Block:
        """Return loops in which each row, and each layer, starts where the one before it ended."""
        columns, rows = self.counts["col"], self.counts["row"]
        row_count, layer = self._int("pass"), self._int("layer")
        rows_done = fold.binary("mul", fold.binary("sub", layer, fold.whole(1), _INT), fold.whole(rows), _INT)
        lines = fold.binary("add", rows_done, row_count, _INT)
        column = self._turned("col", "line", columns, lines)
        row = self._turned("row", "pass", rows, layer)
        return self._loop(
            "layer", self._loop("pass", (*row, *self._loop("line", (*column, *placed), columns)), rows)
        )

    def _turned(self, target: str, counter: str, count: int, number: Expression) -> Block:
        """Return `target` = counter in odd lines, counted backwards in even ones."""
        forward = Assign(f"{self.name}.{target}", self._int(counter), self.span)
        turned = fold.binary("sub", fold.whole(count + 1), self._int(counter), _INT)
        backward = Assign(f"{self.name}.{target}", turned, self.span)
        is_odd = Binary("eq", Binary("mod", number, fold.whole(2), _INT), fold.whole(1), ValueType.BOOL)
        return (If(((is_odd, (forward,)),), (backward,), self.span),)

    def _loop(self, counter: str, inner: Block, count: int | None = None) -> Block:
        last = self.counts[counter] if count is None else count
        loop = For(f"{self.name}.{counter}", fold.whole(1), fold.whole(last), fold.whole(1), inner, self.span)
        if not self.flag or counter == "layer":
            return (loop,)
        left = VariableExpression(self.flag, ValueType.BOOL)
        return (loop, If(((left, (Break(self.span),)),), (), self.span))

    def _location(self) -> Expression:
        """Return the location: origin + (col-1)·v1 + (row-1)·v2 + (layer-1)·v3 in the work frame."""
        axes: list[Expression] = [fold.real(c) for c in self.pattern.origin[:3]]
        for counter, step in zip(("col", "row", "layer"), self.pattern.steps, strict=False):
            index = fold.to_real(fold.binary("sub", self._int(counter), fold.whole(1), _INT))
            for k in range(3):
                if step[k]:
                    way = fold.binary("mul", index, fold.real(step[k]), _REAL)
                    axes[k] = fold.binary("add", axes[k], way, _REAL) if fold.number_of(axes[k]) != 0 else way
        orientation = Constant(self.pattern.origin[3:], ValueType.ORI)
        pose = fold.make_pose(fold.vector(axes[0], axes[1], axes[2]), orientation)
        values = tuple(map(fold.real, self.pattern.external))
        location = fold.external(pose, values) if values else pose
        location = fold.in_posture(location, self.pattern.posture)
        if self.pattern.moving:
            return fold.in_frame(location, self.pattern.moving)
        is_turned = self.pattern.X_KF[3:] != fold.IDENTITY[3:]
        return fold.in_axes(location, self.pattern.X_KF) if is_turned else location

    def _int(self, counter: str) -> Expression:
        return VariableExpression(f"{self.name}.{counter}", _INT)


def _uses(block: Block, flag: str) -> bool:
    """Return whether `flag` is set anywhere in a block."""
    for statement in block:
        match statement:
            case Assign(name=name) if name == flag:
                return True
            case If(branches=branches, otherwise=otherwise):
                if any(_uses(b, flag) for _, b in branches) or _uses(otherwise, flag):
                    return True
            case _:
                inner = getattr(statement, "body", ()) or getattr(statement, "otherwise", ())
                if _uses(inner, flag):
                    return True
    return False
