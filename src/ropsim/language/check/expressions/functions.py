"""The fixed functions of expressions."""

from collections.abc import Callable
from typing import NoReturn

from ropsim.core import did_you_mean
from ropsim.language.check.expressions import arithmetic, calls_inside, convert, other_values, values
from ropsim.language.check.scope import fold, units
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import ANGLE, INT, LENGTH, NUMBER, POSE, Type, Value, article, known
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.program import Binary, ValueType

_REAL = ValueType.REAL


def call(body: Body, node: nodes.Function) -> Value:
    """Return the value of a function.

    Raises:
        RejectedError: the function is unknown, or its arguments do not fit.
    """
    known_function = _FUNCTIONS.get(node.name.text.lower())
    if known_function is None:
        _no_function(body, node)
    count, make = known_function
    if len(node.arguments) != count:
        message = (
            f"`{node.name.text}` takes {count} value{'s' if count > 1 else ''}, found {len(node.arguments)}"
        )
        body.fail(kinds.ARGUMENTS, node, message)
    for argument in node.arguments:
        if argument.name is not None:
            message = f"`{node.name.text}` takes values without names, found `{argument.name.text} =`"
            body.fail(kinds.ARGUMENTS, argument.name, message, "write the value alone")
    return make(body, node)


def _no_function(body: Body, node: nodes.Function) -> NoReturn:
    signature = body.world.signatures.get(node.name.text)
    if node.name.text in body.tasks or (signature is not None and signature.result is not None):
        calls_inside.refuse(body, node)
    if signature is not None:
        hint = "give its header a result: `-> type`"
        body.fail(name_kinds.UNKNOWN_FUNCTION, node.name, f"task `{node.name.text}` returns no value", hint)
    other_values.refuse_function(body, node)
    _refuse_misspelt_task(body, node)
    body.unknown(name_kinds.UNKNOWN_FUNCTION, node.name, "function", _FUNCTIONS)


def _refuse_misspelt_task(body: Body, node: nodes.Function) -> None:
    """Report a task whose result is assigned and whose name is nearer than that of any function.

    Raises:
        RejectedError: it is one.
    """
    statement: object = body.line.statement
    while isinstance(statement, syntax.If):
        statement = statement.body
    if not isinstance(statement, syntax.Assign) or statement.value is not node:
        return
    tasks = [name for name, one in body.world.signatures.items() if one.result is not None]
    near = did_you_mean(node.name.text, (*tasks, *_FUNCTIONS))
    fix = near.split("`")[1] if near else ""
    if fix in tasks:
        message = f"there is no function or task `{node.name.text}`"
        body.fail(name_kinds.UNKNOWN_FUNCTION, node.name, message, near, fix=fix)


def _distance(body: Body, node: nodes.Function) -> Value:
    a, b = (values.expect(body, n, POSE, "an operand of `dist`") for n in node.values)
    return Value(Binary("distance", a, b, _REAL), LENGTH)


def _angle_function(body: Body, node: nodes.Function) -> Value:
    name = node.name.text.lower()
    angle = values.expect(body, node.values[0], ANGLE, f"the operand of `{name}`")
    return Value(fold.unary(name, angle, _REAL), NUMBER)


def _arc_function(body: Body, node: nodes.Function) -> Value:
    name = node.name.text.lower()
    number = values.expect(body, node.values[0], NUMBER, f"the operand of `{name}`")
    return Value(fold.unary(name, number, _REAL), ANGLE)


def _atan2(body: Body, node: nodes.Function) -> Value:
    y, x = (values.check(body, n) for n in node.values)
    a, b, kind = arithmetic.alike(body, "atan2", y, x, node)
    if kind == INT:
        a, b = fold.to_real(a), fold.to_real(b)
    return Value(fold.binary("atan2", a, b, _REAL), ANGLE)


def _root(body: Body, node: nodes.Function) -> Value:
    argument = node.values[0]
    value = values.check(body, argument)
    kind = known(value.type)
    dimension = kind.dimension if isinstance(kind, Type) and kind.value is _REAL else units.NUMBER
    rooted = units.root(dimension)
    if (isinstance(kind, Type) and not kind.is_number) or rooted is None:
        body.fail(
            kinds.WRONG_DIMENSION,
            argument,
            f"`sqrt` has no meaning for {article(kind)}",
            "its operand is a number or a square",
        )
    return Value(fold.unary("sqrt", convert.real(value), _REAL), Type(_REAL, rooted), value.is_bare)


def _absolute(body: Body, node: nodes.Function) -> Value:
    argument = node.values[0]
    value = values.check(body, argument)
    kind = known(value.type)
    if isinstance(kind, Type) and not kind.is_number:
        body.fail(kinds.WRONG_TYPE, argument, f"`abs` needs a number, found {article(kind)}")
    return Value(
        fold.unary("abs", value.expression, kind.value if isinstance(kind, Type) else _REAL),
        kind,
        value.is_bare,
    )


def _extreme(body: Body, node: nodes.Function) -> Value:
    name = node.name.text.lower()
    left, right = (values.check(body, n) for n in node.values)
    for value, argument in ((left, node.values[0]), (right, node.values[1])):
        kind = known(value.type)
        if isinstance(kind, Type) and not kind.is_number:
            body.fail(kinds.WRONG_TYPE, argument, f"`{name}` needs numbers, found {article(kind)}")
    a, b, kind = arithmetic.alike(body, name, left, right, node)
    is_bare = left.is_bare and right.is_bare
    return Value(fold.binary(name, a, b, kind.value if isinstance(kind, Type) else _REAL), kind, is_bare)


def _to_whole(body: Body, node: nodes.Function) -> Value:
    name = node.name.text.lower()
    value = values.check(body, node.values[0])
    kind = known(value.type)
    if kind == INT:
        return value
    expression = convert.to(body, value, NUMBER, node.values[0], f"the operand of `{name}`")
    return Value(fold.unary(name, expression, ValueType.INT), INT, is_bare=True)


_FUNCTIONS: dict[str, tuple[int, Callable[[Body, nodes.Function], Value]]] = {
    "dist": (2, _distance),
    "sqrt": (1, _root),
    "sin": (1, _angle_function),
    "cos": (1, _angle_function),
    "tan": (1, _angle_function),
    "asin": (1, _arc_function),
    "acos": (1, _arc_function),
    "atan2": (2, _atan2),
    "abs": (1, _absolute),
    "min": (2, _extreme),
    "max": (2, _extreme),
    "round": (1, _to_whole),
    "trunc": (1, _to_whole),
}

NAMES = frozenset(_FUNCTIONS)
"""All fixed functions."""
