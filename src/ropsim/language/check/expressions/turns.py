"""Orientation terms of a location: `; down, rz 45`."""

import math
from collections.abc import Callable

from ropsim.language.check.doubts import radians
from ropsim.language.check.expressions import components, convert, values
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import ANGLE, NUMBER, POSE, Type
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.program import Constant, Expression, ValueType
from ropsim.spatial import PoseTuple, quaternion

_ORIGIN = Constant((0.0, 0.0, 0.0), ValueType.VEC)
_UNTURNED = fold.pose(fold.IDENTITY)
_ZERO = fold.real(0.0)
_POLAR = ("pitch", "roll", "yaw")
_STRAIGHT_DOWN = math.pi / 2.0
_NOT_UNIT = 1e-3
"""A quaternion whose length differs more than this from 1 is hardly meant."""


def oriented(
    body: Body, position: Expression, terms: tuple[nodes.Turn, ...], base: Callable[[], PoseTuple]
) -> Expression:
    """Return the pose of a position and orientation terms; `base` returns X_BC of their frame.

    The terms are carried out from left to right, each about the fixed axes of the frame. `pitch`, `roll` and
    `yaw` belong together and follow the convention of five numbers; a missing pitch is 90° (down).

    Raises:
        RejectedError: a term is wrong.
    """
    for term in terms:
        radians.check_term(body, term)
    polar = [t for t in terms if t.word in _POLAR]
    if polar:
        if len(polar) < len(terms) or len({t.word for t in polar}) < len(polar):
            body.fail(
                kinds.WRONG_TYPE,
                terms[-1],
                "`pitch`, `roll` and `yaw` stand alone, each once",
                "use `rx`, `ry`, `rz` instead",
            )
        angles = {t.word: _angle(body, t, 0) for t in polar}
        pitch = angles.get("pitch", fold.real(_STRAIGHT_DOWN))
        roll = angles.get("roll", fold.real(0.0))
        return components.polar(base(), position, pitch, roll, angles.get("yaw"))
    if len(terms) == 1 and terms[0].word == "rpy":
        orientation = fold.zyx(*(_angle(body, terms[0], k) for k in (2, 1, 0)))
        if isinstance(orientation, Constant):
            return fold.make_pose(position, orientation)
        return fold.make_pose(position, components.orientation_of(fold.make_pose(_ORIGIN, orientation)))
    rotation: Expression = _UNTURNED
    for term in terms:
        rotation = fold.compose(_rotation(body, term), rotation)
    return fold.make_pose(position, components.orientation_of(rotation))


def _rotation(body: Body, term: nodes.Turn) -> Expression:
    """Return a pose without translation."""
    match term.word:
        case "down":
            return fold.pose((0.0, 0.0, 0.0, *components.DOWN))
        case "rpy":
            return _turned(_angle(body, term, 2), _angle(body, term, 1), _angle(body, term, 0))
        case "rx":
            return _turned(_ZERO, _ZERO, _angle(body, term, 0))
        case "ry":
            return _turned(_ZERO, _angle(body, term, 0), _ZERO)
        case "rz":
            return _turned(_angle(body, term, 0), _ZERO, _ZERO)
        case "euler":
            return _euler(body, term)
        case "quat":
            return _quaternion(body, term)
        case "rotvec":
            return _rotation_vector(body, term)
    return _like(body, term)


def _turned(c: Expression, b: Expression, a: Expression) -> Expression:
    return fold.make_pose(_ORIGIN, fold.zyx(c, b, a))


def _euler(body: Body, term: nodes.Turn) -> Expression:
    """Return the rotation about moving axes: `euler ZYX c b a` is Rz(c)·Ry(b)·Rx(a)."""
    rotation: Expression = _UNTURNED
    for k, axis in enumerate(term.axes):
        angle = _angle(body, term, k)
        one = _turned(*(angle if axis == letter else _ZERO for letter in "ZYX"))
        rotation = fold.compose(rotation, one)
    return rotation


def _quaternion(body: Body, term: nodes.Turn) -> Expression:
    w, x, y, z = (_constant(body, n, NUMBER) for n in term.values)
    length = math.sqrt(w * w + x * x + y * y + z * z)
    if length < 1e-6:
        body.fail(
            kinds.OUT_OF_RANGE,
            term,
            "the quaternion has no direction: all its numbers are zero",
            "the upright one is `quat 1 0 0 0`",
        )
    unit = quaternion.normalize((w, x, y, z))
    if abs(length - 1.0) > _NOT_UNIT:
        text = "quat " + " ".join(f"{round(number / length, 7) + 0.0:.7g}" for number in (w, x, y, z))
        message = f"the length of this quaternion is {length:g}, not 1"
        body.warn(kinds.NOT_OF_UNIT_LENGTH, term, message, f"write `{text}`", text)
    return fold.pose((0.0, 0.0, 0.0, *unit))


def _rotation_vector(body: Body, term: nodes.Turn) -> Expression:
    """Return the rotation by the length of a vector of angles about its direction."""
    x, y, z = (_constant(body, n, ANGLE) for n in term.values)
    angle = math.sqrt(x * x + y * y + z * z)
    scale = math.sin(angle / 2.0) / angle if angle > 0.0 else 0.5
    return fold.pose(
        (0.0, 0.0, 0.0, *quaternion.normalize((math.cos(angle / 2.0), x * scale, y * scale, z * scale)))
    )


def _like(body: Body, term: nodes.Turn) -> Expression:
    assert term.like is not None
    model = values.expect(body, term.like, POSE, "the model of `like`")
    return fold.make_pose(_ORIGIN, components.orientation_of(components.numbers_in_frame(body, model)))


def _angle(body: Body, term: nodes.Turn, index: int) -> Expression:
    return values.expect(body, term.values[index], ANGLE, f"the angle of `{term.word}`")


def _constant(body: Body, node: nodes.Node, wanted: Type) -> float:
    expression = values.expect(body, node, wanted, "a number of the orientation")
    number = fold.number_of(convert.constant(body, expression, node, "a number of the orientation"))
    return float(number or 0.0)
