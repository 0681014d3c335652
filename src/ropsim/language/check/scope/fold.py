"""Makers of SIR expressions that compute constants at once."""

import operator
from collections.abc import Callable
from dataclasses import replace
from math import isfinite

from ropsim.core import maker
from ropsim.flow import PostureRequest, TargetOrientation
from ropsim.icr import INT_MAX, INT_MIN, Location, composed, computed, pose_part
from ropsim.program import (
    Binary,
    Component,
    Constant,
    Expression,
    InAxes,
    InFrame,
    InPosture,
    MakeExternal,
    MakePose,
    MakeVector,
    MakeZyx,
    Offset,
    Unary,
    ValueType,
)
from ropsim.spatial import PoseTuple, quaternion

_REAL, _INT = ValueType.REAL, ValueType.INT

IDENTITY: PoseTuple = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)

constant, _binary = maker(Constant), maker(Binary)
_vector, _pose = maker(MakeVector), maker(MakePose)
TRUE = Constant(True, ValueType.BOOL)  # noqa: FBT003 - the value is the datum
FALSE = Constant(False, ValueType.BOOL)  # noqa: FBT003 - the value is the datum

_UNARY = {
    "abs": "ABS",
    "neg": "NEG",
    "sqrt": "SQRT",
    "sin": "SIN",
    "cos": "COS",
    "tan": "TAN",
    "asin": "ASIN",
    "acos": "ACOS",
    "trunc": "TRUNC",
    "round": "ROUND",
    "to_real": "I2R",
}
_BINARY = {
    "add": "ADD",
    "sub": "SUB",
    "mul": "MUL",
    "div": "DIV",
    "mod": "MOD",
    "min": "MIN",
    "max": "MAX",
    "atan2": "ATAN2",
    "eq": "EQ",
    "ne": "NE",
    "lt": "LT",
    "le": "LE",
    "gt": "GT",
    "ge": "GE",
}
"""The instructions that lowering emits, so that a constant has the bits that the machine would compute."""

_NUMBERS = (int, float)
_BY_TYPE = frozenset(_BINARY) - {"atan2"} | {"abs", "neg"}
"""Operations that are two instructions, one for INT and one for REAL."""

_PLAIN: dict[str, Callable[[float, float], float]] = {
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "div": operator.truediv,
}
"""Constant folding: operations of the machine on REALs by Python's equal ones, if the result is finite."""

_SIGNS = {"add": "+", "sub": "-", "mul": "*", "div": "/", "neg": "-"}


def boolean(value: object) -> Constant:
    """Return the truth value of a condition."""
    return TRUE if value else FALSE


def real(value: float) -> Constant:
    """Return a REAL."""
    return constant(float(value), _REAL)


def whole(value: int) -> Constant:
    """Return an INT."""
    return constant(int(value), _INT)


def pose(value: Location) -> Constant:
    """Return a POSE, with values of external axes where the location has some."""
    return Constant(tuple(map(float, value)), ValueType.POSE)


def number_of(expression: Expression) -> float | None:
    """Return the value of a constant number, else None."""
    if type(expression) is Constant:
        kind = expression.type
        if kind is _REAL or kind is _INT:
            value = expression.value
            return value if isinstance(value, _NUMBERS) else None
    return None


def pose_of(expression: Expression) -> PoseTuple | None:
    """Return the pose of a constant POSE, without values of external axes, else None."""
    value = location_of(expression)
    return None if value is None else pose_part(value)


def location_of(expression: Expression) -> Location | None:
    """Return the value of a constant POSE, with the values of external axes that it carries, else None."""
    if isinstance(expression, Constant) and expression.type is ValueType.POSE:
        return expression.value if isinstance(expression.value, tuple) else None
    return None


def unary(op: str, operand: Expression, kind: ValueType) -> Expression:
    """Return `op` of a number or truth value.

    Raises:
        ArithmeticError: the operand is outside the domain of the function, or the result has no place.
    """
    if isinstance(operand, Constant):
        if op == "not":
            return boolean(not operand.value)
        number = number_of(operand)
        if op == "neg" and operand.type is kind is _REAL and isinstance(number, float):
            return real(-number)
        if number is not None and op in _UNARY:
            return _computed(op, _UNARY[op], kind, operand.type, number)
    return Unary(op, operand, kind)


def to_real(operand: Expression) -> Expression:
    """Return a number as REAL."""
    number = number_of(operand)
    return Unary("to_real", operand, _REAL) if number is None else real(number)


def binary(op: str, left: Expression, right: Expression, kind: ValueType) -> Expression:
    """Return `left op right` of numbers, and `eq` or `ne` of truth values.

    Raises:
        ArithmeticError: division by zero, or a result that has no place.
    """
    a, b = number_of(left), number_of(right)
    if b == 0 and op in ("div", "mod"):
        raise ZeroDivisionError("division by zero")
    if a is not None and b is not None and op in _BINARY:
        if kind is _REAL and op in _PLAIN:
            result = _PLAIN[op](float(a), float(b))
            if isfinite(result):
                return real(result)
        of = left.type if left.type is _REAL else right.type
        return _computed(op, _BINARY[op], kind, of, a, b)
    if op in ("eq", "ne") and isinstance(left, Constant) and isinstance(right, Constant):
        return boolean((bool(left.value) == bool(right.value)) is (op == "eq"))
    return _simplified(op, a, b, left, right) or _binary(op, left, right, kind)


def scaled(operand: Expression, factor: float) -> Expression:
    """Return a REAL times a number, as `binary` makes it.

    Raises:
        ArithmeticError: the result has no place.
    """
    number = number_of(operand)
    if number is not None and isfinite(result := float(number) * factor):
        return real(result)
    return binary("mul", operand, real(factor), _REAL)


def _computed(op: str, instruction: str, kind: ValueType, of: ValueType, *numbers: float) -> Expression:
    """Return the result of the machine for constant numbers; `of` is REAL where one of them is."""
    is_real = kind is ValueType.REAL or of is ValueType.REAL
    if op in ("round", "trunc", "to_real") and not any(isinstance(n, float) for n in numbers):
        return whole(int(numbers[0])) if kind is ValueType.INT else real(numbers[0])
    if op in _BY_TYPE:
        instruction += ".R" if is_real else ".I"
    given = map(float, numbers) if is_real else numbers
    try:
        value = computed(instruction, *given)
    except ZeroDivisionError:
        raise
    except ArithmeticError as error:
        raise ArithmeticError(str(error).replace(instruction, _SIGNS.get(op, op))) from None
    assert isinstance(value, bool | int | float)
    if kind is ValueType.BOOL:
        return boolean(value)
    return whole(int(value)) if kind is ValueType.INT else real(value)


def _simplified(
    op: str, a: float | None, b: float | None, left: Expression, right: Expression
) -> Expression | None:
    """Return the operand that is left when the other changes no bit of it and cannot trap.

    That is x * 1 and x / 1, and of whole numbers x + 0 and x - 0. It is not x + 0.0, which makes 0.0 of
    -0.0, and not x * 0, which would hide a division by zero in x.
    """
    is_whole = left.type is right.type is _INT
    if op == "add" and a == 0 and is_whole:
        return right
    if op in ("add", "sub") and b == 0 and is_whole:
        return left
    if op == "mul" and a == 1:
        return right
    if op in ("mul", "div") and b == 1:
        return left
    return None


def conjunction(op: str, left: Expression, right: Expression) -> Expression:
    """Return `left and right` or `left or right`."""
    if isinstance(left, Constant) and isinstance(right, Constant):
        both = bool(left.value), bool(right.value)
        return boolean(all(both) if op == "and" else any(both))
    return Binary(op, left, right, ValueType.BOOL)


def vector(x: Expression, y: Expression, z: Expression) -> Expression:
    """Return the VEC of three REALs."""
    a, b, c = number_of(x), number_of(y), number_of(z)
    if a is None or b is None or c is None:
        return _vector(x, y, z, ValueType.VEC)
    return constant((float(a), float(b), float(c)), ValueType.VEC)


def zyx(c: Expression, b: Expression, a: Expression) -> Expression:
    """Return the ORI Rz(c)·Ry(b)·Rx(a)."""
    r, p, y = number_of(a), number_of(b), number_of(c)
    if r is None or p is None or y is None:
        return MakeZyx(c, b, a)
    return constant(quaternion.from_zyx(float(y), float(p), float(r)), ValueType.ORI)


def make_pose(position: Expression, orientation: Expression) -> Expression:
    """Return the POSE of a VEC and an ORI."""
    p = position.value if isinstance(position, Constant) else None
    q = orientation.value if isinstance(orientation, Constant) else None
    if isinstance(p, tuple) and isinstance(q, tuple):
        return constant((*p, *q), ValueType.POSE)
    return _pose(position, orientation, ValueType.POSE)


def in_frame(operand: Expression, frame: str) -> Expression:
    """Return a POSE with the numbers of `operand` in a frame of its own; without a name, in none."""
    operand = without_frame(operand)
    is_known = isinstance(numbers_of(operand), Constant)
    return operand if is_known and not frame else InFrame(operand, frame)


def in_posture(operand: Expression, request: PostureRequest | None) -> Expression:
    """Return a POSE with a posture request; None changes nothing."""
    if request is None:
        return operand
    if isinstance(operand, InFrame):
        return InFrame(in_posture(operand.operand, request), operand.frame)
    return InPosture(operand.operand if isinstance(operand, InPosture) else operand, request)


def with_free_orientation(operand: Expression) -> Expression:
    """Return a POSE of which the position counts, with the posture and the frame that it is seen to have."""
    if isinstance(operand, InFrame):
        return InFrame(with_free_orientation(operand.operand), operand.frame)
    request = operand.request if isinstance(operand, InPosture) else PostureRequest()
    return in_posture(operand, replace(request, orientation=TargetOrientation.FREE))


def opened(operand: Expression) -> tuple[Expression, PostureRequest | None, str]:
    """Return a POSE without posture and frame of its own, as far as these are known, and them."""
    frame = operand.frame if isinstance(operand, InFrame) else ""
    inner = without_frame(operand)
    if isinstance(inner, InPosture):
        return inner.operand, inner.request, frame
    return inner, None, frame


def numbers_of(operand: Expression) -> Expression:
    """Return the numbers of a POSE alone, and its values of external axes."""
    return opened(operand)[0]


def closed(numbers: Expression, request: PostureRequest | None, frame: str) -> Expression:
    """Return a POSE from the parts that `opened` returned."""
    return in_frame(in_posture(numbers, request), frame)


def without_frame(operand: Expression) -> Expression:
    """Return the numbers of a POSE alone, where it is known that it has a frame of its own."""
    return operand.operand if isinstance(operand, InFrame) else operand


def compose(left: Expression, right: Expression) -> Expression:
    """Return X_AC from X_AB and X_BC, with the values of external axes of the one that has some.

    Where `right` is numbers alone, independent of their frame, the frame of `left` stays.
    """
    if type(left) is type(right) is Constant:
        return _composed(left, right)
    if isinstance(left, InFrame):
        return InFrame(compose(left.operand, without_frame(right)), left.frame)
    if isinstance(right, InFrame) and right.frame:
        return InFrame(compose(left, right.operand), right.frame)
    if isinstance(left, InPosture):
        step = right if isinstance(right, InFrame) else numbers_of(right)
        return InPosture(compose(left.operand, step), left.request)
    if isinstance(right, InPosture):
        return InPosture(compose(left, right.operand), right.request)
    return _composed(left, right)


def _composed(left: Expression, right: Expression) -> Expression:
    a, b = location_of(left), location_of(right)
    if a == IDENTITY:
        return right
    if b == IDENTITY:
        return left
    if a is not None and b is not None:
        return pose(composed(a, b))
    return Binary("compose", left, right, ValueType.POSE)


def reframe(change: PoseTuple, location: Expression) -> Expression:
    """Return X_AC from X_AB and X_BC; a location in a frame that moves stays unchanged."""
    if change == IDENTITY or (isinstance(location, InFrame) and location.frame):
        return location
    if isinstance(numbers_of(location), Constant):
        return compose(pose(change), location)
    return Binary("reframe", pose(change), location, ValueType.POSE)


def in_axes(location: Expression, X_KF: PoseTuple) -> Expression:
    """Return a POSE that keeps the axes of the frame in which it was given; one that moves has its own."""
    if isinstance(location, InFrame) and location.frame:
        return location
    inner = location.operand if isinstance(location, InAxes) else location
    return InAxes(inner, X_KF[3:])


def offset(location: Expression, way: Expression) -> Expression:
    """Return a POSE shifted along the axes that it keeps."""
    return Offset(location, way)


def external(location: Expression, values: tuple[Expression, ...]) -> Expression:
    """Return a POSE with REAL values of external axes in place of its present ones."""
    if isinstance(location, InFrame):
        return InFrame(external(location.operand, values), location.frame)
    if isinstance(location, InPosture):
        return InPosture(external(location.operand, values), location.request)
    pose_now, known = pose_of(location), [v for v in map(number_of, values) if v is not None]
    if pose_now is None or len(known) < len(values):
        return MakeExternal(location, values)
    return pose((*pose_now, *known))


def component(operand: Expression, index: int) -> Expression:
    """Return component `index` (x y z, then rx ry rz) of a POSE."""
    operand = numbers_of(operand)
    value = pose_of(operand)
    if value is None:
        return Component(operand, index)
    if index < 3:
        return real(value[index])
    rz, ry, rx = quaternion.to_zyx(value[3:])
    return real((rx, ry, rz)[index - 3])


def is_whole(value: float) -> bool:
    """Return whether a number is one that an INT holds."""
    return INT_MIN <= value <= INT_MAX and value == int(value)
