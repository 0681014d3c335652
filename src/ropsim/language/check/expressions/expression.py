"""Every kind of expression: syntax to a typed value in SI units."""

from functools import lru_cache

from ropsim.icr import MAX_AXES
from ropsim.language.check.doubts import radians
from ropsim.language.check.expressions import arithmetic, components, convert, functions, lists, poses, values
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body, Expressions
from ropsim.language.check.scope.types import (
    ANGLE,
    BOOL,
    INT,
    JOINTS,
    LENGTH,
    NUMBER,
    POSE,
    STR,
    Unknown,
    Value,
    article,
    bind,
    known,
    real,
)
from ropsim.language.check.scope.units import UNITS
from ropsim.language.check.scope.world import Variable
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.program import Constant, Expression, MakeJoints, ValueType
from ropsim.program import Variable as VariableExpression

_MEASURED = {unit: real(dimension) for unit, (dimension, _) in UNITS.items()}
_COUNTERS = ("row", "col", "layer")


def _number(_: Body, node: nodes.Number) -> Value:
    return _number_value(node.value, node.unit, node.is_whole)


@lru_cache(maxsize=4096)
def _number_value(number: float, unit: str, is_whole: bool) -> Value:  # noqa: FBT001 - as in the node
    """Return the value of a number: most texts say the same ones again and again."""
    if unit:
        return Value(fold.real(number * UNITS[unit][1]), _MEASURED[unit])
    if is_whole:
        return Value(fold.whole(int(number)), INT, is_bare=True)
    return Value(fold.real(number), NUMBER, is_bare=True)


def _literal(body: Body, node: nodes.Literal) -> Value:
    if node.word == "here":
        return Value(poses.here(body), POSE)
    if node.word == "home":
        hint = "write `mov home`, or give coordinates: `joints(…)`"
        body.fail(kinds.NO_VALUE_HERE, node, "`home` is a target of `mov` only, it has no value", hint)
    return Value(fold.boolean(node.word in ("true", "on")), BOOL)


def _text(_: Body, node: nodes.Text) -> Value:
    return Value(Constant(node.value, ValueType.STR), STR)


def _unary(body: Body, node: nodes.Unary) -> Value:
    if node.op == "neg":
        return arithmetic.negative(body, values.check(body, node.operand), node)
    operand = values.expect(body, node.operand, BOOL, "the operand of `not`")
    return Value(fold.unary("not", operand, ValueType.BOOL), BOOL)


def _external(body: Body, node: nodes.External) -> Value:
    return poses.with_external(body, values.check(body, node.operand), node)


def _free(body: Body, node: nodes.Free) -> Value:
    return poses.with_free_orientation(body, values.check(body, node.operand), node)


def _binary(body: Body, node: nodes.Binary) -> Value:
    if node.op in ("and", "or"):
        left = values.expect(body, node.left, BOOL, f"the left side of `{node.op}`")
        right = values.expect(body, node.right, BOOL, f"the right side of `{node.op}`")
        return Value(fold.conjunction(node.op, left, right), BOOL)
    if node.op in ("above", "offset", "rel"):
        return poses.moved(body, values.check(body, node.left), node)
    left_value, right_value = values.check(body, node.left), values.check(body, node.right)
    if node.op in ("+", "-", "*", "/", "mod"):
        return arithmetic.binary(body, node, left_value, right_value)
    return arithmetic.comparison(body, node, left_value, right_value)


def _state(body: Body, node: nodes.State) -> Value:
    operand = values.expect(body, node.operand, BOOL, "the left side of `is`")
    holds = (node.word in ("on", "true")) != node.negated
    return Value(operand if holds else fold.unary("not", operand, ValueType.BOOL), BOOL)


def _joints(body: Body, node: nodes.Joints) -> Value:
    _check_count(body, node)
    expressions: list[Expression] = []
    angles: list[nodes.Node] = []
    axes = body.world.environment.axes
    for k, item in enumerate(node.values):
        value = values.check(body, item)
        is_length = axes[k] == "length" if k < len(axes) else known(value.type) == LENGTH
        expressions.append(convert.to(body, value, LENGTH if is_length else ANGLE, item, f"joint {k + 1}"))
        if not is_length:
            angles.append(item)
    radians.check_joints(body, node, angles)
    numbers = tuple(float(n) for n in map(fold.number_of, expressions) if n is not None)
    if len(numbers) < len(expressions):
        return Value(MakeJoints(tuple(expressions)), JOINTS)
    return Value(Constant(numbers, ValueType.JOINTS), JOINTS)


def _check_count(body: Body, node: nodes.Joints) -> None:
    """Report another number of coordinates than the robot has axes, or than the text gave before.

    Raises:
        RejectedError: it is another one.
    """
    found, axes = len(node.values), len(body.world.environment.axes)
    wanted = axes or body.joint_count
    if wanted and found != wanted:
        hint = f"the station has {wanted} axes" if axes else f"other `joints(…)` of this text have {wanted}"
        body.fail(kinds.JOINT_COUNT, node, f"`joints(…)` has {found} coordinates, {wanted} are needed", hint)
    if found > MAX_AXES:
        message = f"`joints(…)` has {found} coordinates, at most {MAX_AXES} are allowed"
        body.fail(kinds.JOINT_COUNT, node, message, "give one for each axis of the station")
    body.joint_count = found


def _member(body: Body, node: nodes.Member) -> Value:
    if isinstance(node.operand, nodes.Name) and node.name.text in _COUNTERS:
        symbol = body.find(node.operand.text)
        if isinstance(symbol, Variable) and symbol.has_counters:
            counter = f"{symbol.name}.{node.name.text}"
            return Value(VariableExpression(counter, ValueType.INT), INT, is_bare=True)
    value = values.check(body, node.operand)
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
    index, member_type = values.member(body, node.name)
    value_in_frame = components.numbers_in_frame(body, value.expression)
    return Value(fold.component(value_in_frame, index), member_type)


EXPRESSIONS: Expressions = {
    nodes.Number: _number,
    nodes.Text: _text,
    nodes.Literal: _literal,
    nodes.Name: values.name,
    nodes.Unary: _unary,
    nodes.Binary: _binary,
    nodes.Rebase: poses.rebased,
    nodes.External: _external,
    nodes.Free: _free,
    nodes.State: _state,
    nodes.Function: functions.call,
    nodes.Tuple: poses.location,
    nodes.Joints: _joints,
    nodes.Member: _member,
    nodes.Index: lists.indexed,
}
"""How each is checked; values hold values, so the table is handed down with the body."""
