"""Arithmetic and comparisons: dimensions of sums and products, whole and bare numbers."""

from functools import lru_cache

from ropsim.language.check.expressions import convert
from ropsim.language.check.expressions.readings import check_compared, check_reading
from ropsim.language.check.scope import fold, units
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import (
    BOOL,
    INT,
    NUMBER,
    AnyType,
    Type,
    Unknown,
    Value,
    article,
    bind,
    known,
    real,
    valued,
)
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.program import Expression, SignalValue, ValueType

_NAMES = {"+": "add", "-": "sub", "*": "mul", "/": "div", "mod": "mod"}
_REAL, _INT, _BOOL = ValueType.REAL, ValueType.INT, ValueType.BOOL
_COMPARE = {"=": "eq", "==": "eq", "<>": "ne", "<": "lt", "<=": "le", ">": "gt", ">=": "ge"}


def negative(body: Body, value: Value, node: nodes.Unary) -> Value:
    """Return minus a number."""
    kind = _number(body, value, node.operand, "-")
    return Value(fold.unary("neg", value.expression, _value(kind)), kind, value.is_bare)


def binary(body: Body, node: nodes.Binary, left: Value, right: Value) -> Value:
    """Return a sum, difference, product, quotient or remainder.

    Raises:
        RejectedError: the operands do not go together.
    """
    first = _number(body, left, node.left, node.op)
    second = _number(body, right, node.right, node.op)
    if node.op in ("*", "/"):
        return _product(node, left, right, first, second)
    a, b, kind = alike(body, node.op, left, right, node)
    result = fold.binary(_NAMES[node.op], a, b, _value(kind))
    return valued(result, kind, left.is_bare and right.is_bare, None)


def comparison(body: Body, node: nodes.Binary, left: Value, right: Value) -> Value:
    """Return the truth of a comparison.

    Raises:
        RejectedError: the operands do not go together.
    """
    if node.op in ("=", "==", "<>") and BOOL in (known(left.type), known(right.type)):
        refuse_level(body, node)
        a = convert.to(body, left, BOOL, node.left, f"the left side of `{node.op}`")
        b = convert.to(body, right, BOOL, node.right, f"the right side of `{node.op}`")
        return Value(fold.binary(_COMPARE[node.op], a, b, _BOOL), BOOL)
    _number(body, left, node.left, node.op)
    _number(body, right, node.right, node.op)
    for signal, other, place in ((left, right, node.right), (right, left, node.left)):
        if isinstance(signal.expression, SignalValue):
            check_reading(body, signal.expression.name, other, place)
        else:
            check_compared(body, signal, other, place)
    if _is_measured(left, right) or _is_measured(right, left):
        a, b = convert.real(left), convert.real(right)
    else:
        a, b, _ = alike(body, node.op, left, right, node)
    return valued(fold.binary(_COMPARE[node.op], a, b, _BOOL), BOOL, is_bare=False, X_KF=None)


def refuse_level(body: Body, node: nodes.Binary) -> None:
    """Report a truth value that is compared with 1 or 0.

    Raises:
        RejectedError: it is.
    """
    for one in (node.right, node.left):
        if isinstance(one, nodes.Number) and not one.unit and one.value in (0.0, 1.0):
            level = "on" if one.value else "off"
            message = f"a truth value is compared with the number `{one.value:g}`"
            body.fail(kinds.WRONG_TYPE, one, message, f"write `{level}`", fix=level)


def _is_measured(signal: Value, quantity: Value) -> bool:
    """Return whether an analog signal is compared with a quantity: it has no unit, so SI units count."""
    kind = known(quantity.type)
    is_quantity = isinstance(kind, Type) and kind.value is _REAL and not quantity.is_bare
    return isinstance(signal.expression, SignalValue) and is_quantity


def alike(
    body: Body, op: str, left: Value, right: Value, node: nodes.Binary | nodes.Function
) -> tuple[Expression, Expression, AnyType]:
    """Return two numbers as values of one type, and that type.

    A bare number takes the dimension of the other operand; two bare numbers stay bare.

    Raises:
        RejectedError: the dimensions differ.
    """
    a, b = known(left.type), known(right.type)
    if left.is_bare and right.is_bare:
        if a == INT and b == INT:
            return left.expression, right.expression, INT
        return convert.real(left), convert.real(right), NUMBER
    wanted, other = (b, left) if left.is_bare else (a, right)
    if isinstance(a, Type) and isinstance(b, Type) and not left.is_bare and not right.is_bare:
        if a.dimension != b.dimension:
            message = f"`{op}` needs two quantities of one dimension, found {a} and {b}"
            body.fail(kinds.WRONG_DIMENSION, node, message, "check the units of both sides")
        return left.expression, right.expression, a
    place: nodes.Node = node
    if isinstance(node, nodes.Binary):
        place = node.left if other is left else node.right
    converted = convert.to(body, other, wanted, place, f"the operand of `{op}`")
    return (converted, right.expression, wanted) if other is left else (left.expression, converted, wanted)


def _product(node: nodes.Binary, left: Value, right: Value, a: AnyType, b: AnyType) -> Value:
    """Return a product or quotient of numbers whose types are these."""
    is_bare = left.is_bare and right.is_bare
    if node.op == "*" and a == INT and b == INT:
        return Value(fold.binary("mul", left.expression, right.expression, _INT), INT, is_bare)
    x, y = convert.real(left), convert.real(right)
    kind = _product_type(node.op, left, right, a, b)
    return valued(fold.binary(_NAMES[node.op], x, y, _REAL), kind, is_bare, None)


def _product_type(op: str, left: Value, right: Value, a: AnyType, b: AnyType) -> AnyType:
    """Return the type of a product; an unknown factor times a known quantity counts as a plain number."""
    if isinstance(a, Unknown) and right.is_bare:
        a.has_fraction = a.has_fraction or op == "/"
        return a
    if isinstance(b, Unknown) and left.is_bare and op == "*":
        return b
    first, second = _dimension(a), _dimension(b)
    if second is units.NUMBER and isinstance(a, Type) and a.value is _REAL:
        return a
    return _combined(op, first, second)


def _dimension(kind: AnyType) -> units.Dimension:
    """Return the dimension of a factor; a factor of open type becomes a plain number."""
    if isinstance(kind, Type):
        return kind.dimension if kind.value is _REAL else units.NUMBER
    if kind.bound is None:
        bind(kind, NUMBER)
    return units.NUMBER


@lru_cache(maxsize=1024)
def _combined(op: str, first: units.Dimension, second: units.Dimension) -> Type:
    return real(units.product(first, second) if op == "*" else units.quotient(first, second))


def _number(body: Body, value: Value, node: nodes.Node, op: str) -> AnyType:
    kind = known(value.type)
    if isinstance(kind, Type) and kind.value is not _REAL and kind.value is not _INT:
        hint = ""
        if kind.value is ValueType.POSE:
            hint = (
                "move a location with `above`, `offset` or `rel`"
                if op in "+-"
                else "compare locations by `dist(a, b)`"
            )
        if kind.value is ValueType.STR and op == "+":
            hint = "texts are not joined: `print` shows values behind commas"
        body.fail(kinds.WRONG_TYPE, node, f"`{op}` needs numbers, found {article(kind)}", hint)
    return kind


def _value(kind: AnyType) -> ValueType:
    return kind.value if isinstance(kind, Type) else _REAL
