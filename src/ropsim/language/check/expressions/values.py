"""The value of an expression, of a requested type or any; the values of names."""

from ropsim.core import maker
from ropsim.language.check.doubts import numerals
from ropsim.language.check.expressions import convert, frames, other_values
from ropsim.language.check.scope.body import Body, RejectedError
from ropsim.language.check.scope.types import (
    ANGLE,
    BOOL,
    INT,
    LENGTH,
    NUMBER,
    AnyType,
    Type,
    Value,
    known,
    valued,
)
from ropsim.language.check.scope.world import Listed, Pattern, Poison, Variable
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax.statements import Motion
from ropsim.program import (
    Expression,
    SignalUse,
    SignalValue,
    ValueType,
)
from ropsim.program import Variable as VariableExpression

_MEMBERS = {
    "x": (0, LENGTH),
    "y": (1, LENGTH),
    "z": (2, LENGTH),
    "rx": (3, ANGLE),
    "ry": (4, ANGLE),
    "rz": (5, ANGLE),
}

_expression = maker(VariableExpression)


def expect(body: Body, node: nodes.Node, wanted: AnyType, what: str) -> Expression:
    """Return the expression of a node as a value of a type.

    Raises:
        RejectedError: the node is wrong or does not fit.
    """
    if isinstance(wanted, Type):
        alone = _variable if isinstance(node, nodes.Name) else numerals.fitting
        found: Expression | None = alone(body, node, wanted)
        if found is not None:
            return found
    return convert.to(body, check(body, node), wanted, node, what)


def _variable(body: Body, node: nodes.Node, wanted: Type) -> VariableExpression | None:
    """Return the variable of the requested type behind a name, else None."""
    symbol = body.find(node.text) if isinstance(node, nodes.Name) else None
    if not isinstance(symbol, Variable) or symbol.type is not wanted:
        return None
    body.read.add(symbol.name)
    return _expression(symbol.name, wanted.value)


def check(body: Body, node: nodes.Node) -> Value:
    """Return the value of an expression.

    Raises:
        RejectedError: the expression is wrong; the finding has been reported.
    """
    try:
        return body.expressions[type(node)](body, node)
    except (ArithmeticError, ValueError) as error:
        body.fail(kinds.OUT_OF_RANGE, node, f"the value cannot be computed: {error}", "check the numbers")


def name(body: Body, node: nodes.Name) -> Value:
    """Return the value of a name.

    Raises:
        RejectedError: the name is unknown.
    """
    symbol = body.find(node.text)
    match symbol:
        case Variable():
            body.read.add(symbol.name)
            kind = known(symbol.type)
            expression = _expression(symbol.name, kind.value if isinstance(kind, Type) else ValueType.REAL)
            return valued(expression, kind, kind == INT, None)
        case Value():
            return symbol
        case SignalUse():
            body.used_signals[symbol.name] = symbol
            return Value(
                SignalValue(symbol.name, symbol.type), NUMBER if symbol.type is ValueType.REAL else BOOL
            )
        case Pattern():
            body.fail(
                kinds.WRONG_TYPE,
                node,
                f"`{node.text}` is a pattern, not a value",
                f"write `for each slot in {node.text}`",
            )
        case Listed():
            if body.with_points(symbol, node) is body.each:
                return frames.listed_point(body, symbol, frames.EACH)
            body.fail(
                kinds.WRONG_TYPE,
                node,
                f"`{node.text}` is a list of points, not a value",
                f"write `for each p in {node.text}`, `lin along {node.text}` or `{node.text}[1]`",
            )
        case Poison():
            raise RejectedError
    if body.is_tolerant:
        raise RejectedError
    if node.text in body.past:
        message = f"`{node.text}` is the variable of a loop that has ended"
        hint = f"give `{node.text}` a value before the loop, or copy it to another variable inside"
        body.fail(name_kinds.UNKNOWN_NAME, node, message, hint)
    other_values.refuse_name(body, node)
    candidates = [*visible(body), *_targets(body)] if not body.report.muted else []
    if _is_target(body, node):
        candidates = [one for one in candidates if one not in body.truth_signals()]
    body.unknown(name_kinds.UNKNOWN_NAME, node, "name", candidates)


def _is_target(body: Body, node: nodes.Name) -> bool:
    """Return whether a name stands where the target of a motion does, which is no truth value."""
    statement = body.line.statement
    return isinstance(statement, Motion) and node.end <= statement.target.end


def _targets(body: Body) -> tuple[str, ...]:
    """Return the words that are targets of the line in hand only."""
    statement = body.line.statement
    return ("home",) if isinstance(statement, Motion) and statement.word == "mov" else ()


def visible(body: Body) -> list[str]:
    """Return all names that an expression could use here."""
    own = body.visible()
    names = [name for name in body.declared_names() if name not in own]
    return [*names, *(name for name, one in own.items() if not isinstance(one, Poison) and "__" not in name)]


def member(body: Body, node: nodes.Name) -> tuple[int, Type]:
    """Return index and type of a component of a location.

    Raises:
        RejectedError: the component is unknown.
    """
    if node.text not in _MEMBERS:
        body.unknown(name_kinds.UNKNOWN_MEMBER, node, "component", _MEMBERS)
    return _MEMBERS[node.text]
