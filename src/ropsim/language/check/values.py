"""Expressions: syntax to typed values in SI units."""

from collections.abc import Callable
from typing import Any

from ropsim.language.check import arithmetic, convert, fold, functions, poses
from ropsim.language.check.body import Body, RejectedError
from ropsim.language.check.types import (
    ANGLE,
    BOOL,
    INT,
    JOINTS,
    LENGTH,
    NUMBER,
    POSE,
    STR,
    AnyType,
    Type,
    Unknown,
    Value,
    article,
    bind,
    known,
)
from ropsim.language.check.units import UNITS
from ropsim.language.check.world import Pattern, Poison, Variable
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.program import (
    CommandPose,
    Constant,
    Expression,
    Home,
    MakeJoints,
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
_COUNTERS = ("row", "col", "layer")


def expect(body: Body, node: nodes.Node, wanted: AnyType, what: str) -> Expression:
    """Return the expression of a node as a value of a type.

    Raises:
        RejectedError: the node is wrong or does not fit.
    """
    return convert.to(body, check(body, node), wanted, node, what)


def check(body: Body, node: nodes.Node) -> Value:
    """Return the value of an expression.

    Raises:
        RejectedError: the expression is wrong; the finding has been reported.
    """
    try:
        return _check(body, node)
    except (ArithmeticError, ValueError) as error:
        body.fail(kinds.OUT_OF_RANGE, node, f"the value cannot be computed: {error}", "check the numbers")


def _check(body: Body, node: nodes.Node) -> Value:
    return _CHECKS[type(node)](body, node)


def name(body: Body, node: nodes.Name) -> Value:
    """Return the value of a name.

    Raises:
        RejectedError: the name is unknown.
    """
    symbol = body.find(node.text)
    match symbol:
        case Variable():
            kind = known(symbol.type)
            expression = VariableExpression(
                symbol.name, kind.value if isinstance(kind, Type) else ValueType.REAL
            )
            return Value(expression, kind, is_bare=kind == INT)
        case Value():
            return symbol
        case SignalUse():
            body.world.used_signals[symbol.name] = symbol
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
        case Poison():
            raise RejectedError
    if body.is_tolerant:
        raise RejectedError
    body.unknown(name_kinds.UNKNOWN_NAME, node, "name", visible(body))


def visible(body: Body) -> list[str]:
    """Return all names that an expression could use here."""
    return [n for n, s in {**body.world.symbols, **body.names}.items() if not isinstance(s, Poison)]


def _number(_: Body, node: nodes.Number) -> Value:
    if node.unit:
        dimension, factor = UNITS[node.unit]
        return Value(fold.real(node.value * factor), Type(ValueType.REAL, dimension))
    if node.is_whole:
        return Value(fold.whole(int(node.value)), INT, is_bare=True)
    return Value(fold.real(node.value), NUMBER, is_bare=True)


def _literal(_: Body, node: nodes.Literal) -> Value:
    if node.word == "here":
        return Value(CommandPose(), POSE)
    if node.word == "home":
        return Value(Home(), JOINTS)
    return Value(fold.boolean(node.word in ("true", "on")), BOOL)


def _text(_: Body, node: nodes.Text) -> Value:
    return Value(Constant(node.value, ValueType.STR), STR)


def _unary(body: Body, node: nodes.Unary) -> Value:
    if node.op == "neg":
        return arithmetic.negative(body, check(body, node.operand), node)
    operand = expect(body, node.operand, BOOL, "the operand of `not`")
    return Value(fold.unary("not", operand, ValueType.BOOL), BOOL)


def _rebase(body: Body, node: nodes.Rebase) -> Value:
    return poses.rebased(body, check(body, node.operand), node)


def _function(body: Body, node: nodes.Function) -> Value:
    return functions.call(body, node)


def _tuple(body: Body, node: nodes.Tuple) -> Value:
    return poses.location(body, node)


def _binary(body: Body, node: nodes.Binary) -> Value:
    if node.op in ("and", "or"):
        left = expect(body, node.left, BOOL, f"the left side of `{node.op}`")
        right = expect(body, node.right, BOOL, f"the right side of `{node.op}`")
        return Value(fold.conjunction(node.op, left, right), BOOL)
    if node.op in ("above", "offset", "rel"):
        return poses.moved(body, check(body, node.left), node)
    left_value, right_value = check(body, node.left), check(body, node.right)
    if node.op in ("+", "-", "*", "/", "mod"):
        return arithmetic.binary(body, node, left_value, right_value)
    return arithmetic.comparison(body, node, left_value, right_value)


def _state(body: Body, node: nodes.State) -> Value:
    operand = expect(body, node.operand, BOOL, "the left side of `is`")
    holds = (node.word in ("on", "true")) != node.negated
    return Value(operand if holds else fold.unary("not", operand, ValueType.BOOL), BOOL)


def _joints(body: Body, node: nodes.Joints) -> Value:
    expressions = []
    axes = body.world.environment.axes
    for k, item in enumerate(node.values):
        value = check(body, item)
        is_length = axes[k] == "length" if k < len(axes) else known(value.type) == LENGTH
        expressions.append(convert.to(body, value, LENGTH if is_length else ANGLE, item, f"joint {k + 1}"))
    numbers = [fold.number_of(e) for e in expressions]
    if None in numbers:
        return Value(MakeJoints(tuple(expressions)), JOINTS)
    return Value(Constant(tuple(float(n or 0.0) for n in numbers), ValueType.JOINTS), JOINTS)


def _member(body: Body, node: nodes.Member) -> Value:
    if isinstance(node.operand, nodes.Name) and node.name.text in _COUNTERS:
        counter = body.names.get(f"{node.operand.text}__{node.name.text}")
        if isinstance(counter, Variable):
            return Value(VariableExpression(counter.name, ValueType.INT), INT, is_bare=True)
    value = check(body, node.operand)
    kind = known(value.type)
    if isinstance(kind, Unknown):
        bind(kind, POSE)
    elif kind != POSE:
        body.fail(
            name_kinds.UNKNOWN_MEMBER,
            node.name,
            f"{article(kind)} has no component `{node.name.text}`",
            "locations have components",
        )
    index, member_type = member(body, node.name)
    value_in_frame = poses.numbers_in_frame(body, value.expression)
    return Value(fold.component(value_in_frame, index), member_type)


def member(body: Body, node: nodes.Name) -> tuple[int, Type]:
    """Return index and type of a component of a location.

    Raises:
        RejectedError: there is no such component.
    """
    if node.text not in _MEMBERS:
        body.unknown(name_kinds.UNKNOWN_MEMBER, node, "component", _MEMBERS)
    return _MEMBERS[node.text]


_CHECKS: dict[type, Callable[[Body, Any], Value]] = {
    nodes.Number: _number,
    nodes.Text: _text,
    nodes.Literal: _literal,
    nodes.Name: name,
    nodes.Unary: _unary,
    nodes.Binary: _binary,
    nodes.Rebase: _rebase,
    nodes.State: _state,
    nodes.Function: _function,
    nodes.Tuple: _tuple,
    nodes.Joints: _joints,
    nodes.Member: _member,
}
