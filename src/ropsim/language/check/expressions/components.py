"""The numbers of a location: in which frame, in which convention, and its two halves."""

from ropsim.language.check.expressions import frames
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import POSE, Type, Value, known
from ropsim.program import Constant, Expression, Keeping, Kept, Unary, ValueType
from ropsim.spatial import TOOL_FROM_APPROACH, PoseTuple, quaternion

DOWN = (0.0, 1.0, 0.0, 0.0)
"""Rx(180°): the tool points straight down in its frame; the orientation of three plain numbers."""

UPRIGHT = fold.zyx(fold.real(0.0), fold.real(0.0), fold.real(0.0))
"""The orientation of a pose without other terms."""


def numbers_in_frame(body: Body, location_in_work_frame: Expression) -> Expression:
    """Return X_CT of a location X_KT: the numbers it has in the frame in force.

    A location in a frame that moves has the numbers that it has there.
    """
    return reframed(body, quaternion.invert(frames.read(body)), location_in_work_frame)


def reframed(body: Body, X_AB: PoseTuple, location: Expression) -> Expression:
    """Return X_AC of a location X_BC; one in a frame that moves keeps the numbers that it has there."""
    if body.world.environment.moving:
        return fold.reframe(X_AB, location)
    return fold.compose(fold.pose(X_AB), location)


def pitch_roll(body: Body, location_in_work_frame: Expression) -> tuple[Expression, Expression]:
    """Return pitch and roll of a location in the convention of five numbers."""
    unturned = fold.compose(
        location_in_work_frame, fold.pose((0.0, 0.0, 0.0, *quaternion.conjugate(TOOL_FROM_APPROACH)))
    )
    X_BT = reframed(body, body.world.X_BK, unturned)
    return fold.component(X_BT, 4), fold.component(X_BT, 3)


def frame_in_base(body: Body) -> PoseTuple:
    """Return X_BC of the frame in force; the identity where it moves."""
    if body.in_force.moving:
        return fold.IDENTITY
    return quaternion.compose(body.world.X_BK, body.in_force.X_KC)


def polar(
    X_BC: PoseTuple, position: Expression, pitch: Expression, roll: Expression, yaw: Expression | None
) -> Expression:
    """Return X_CT with R_BT = Rz(azimuth)·Ry(pitch)·Rx(roll)·Ry(90°); `yaw` overrides the azimuth.

    The azimuth is that of the position, which is computed once.

    Args:
        X_BC: frame of the position.
        position: VEC in that frame.
        pitch: REAL [rad].
        roll: REAL [rad].
        yaw: REAL [rad]; None for the azimuth of the position.
    """
    if yaw is not None:
        return _turned(X_BC, position, pitch, roll, yaw)
    if isinstance(position, Constant):
        return _turned(X_BC, position, pitch, roll, _azimuth(X_BC, position))
    kept = Kept(ValueType.VEC)
    result = _turned(X_BC, kept, pitch, roll, _azimuth(X_BC, kept))
    return Keeping(position, result, ValueType.POSE)


def _azimuth(X_BC: PoseTuple, position: Expression) -> Expression:
    point = fold.compose(fold.pose(X_BC), fold.make_pose(position, UPRIGHT))
    return fold.binary("atan2", fold.component(point, 1), fold.component(point, 0), ValueType.REAL)


def _turned(
    X_BC: PoseTuple, position: Expression, pitch: Expression, roll: Expression, yaw: Expression
) -> Expression:
    turned = fold.make_pose(Constant((0.0, 0.0, 0.0), ValueType.VEC), fold.zyx(yaw, pitch, roll))
    R_BT = fold.compose(turned, fold.pose((0.0, 0.0, 0.0, *TOOL_FROM_APPROACH)))
    R_CT = fold.compose(_turn(quaternion.conjugate(X_BC[3:])), R_BT)
    return fold.make_pose(position, orientation_of(R_CT))


def _turn(q: quaternion.Quaternion) -> Expression:
    turned: PoseTuple = (0.0, 0.0, 0.0, *q)
    return fold.pose(turned)


def position_of(expression: Expression) -> Expression:
    """Return the VEC of a POSE."""
    expression = fold.numbers_of(expression)
    value = fold.pose_of(expression)
    if value is not None:
        return Constant(value[:3], ValueType.VEC)
    return Unary("position", expression, ValueType.VEC)


def orientation_of(expression: Expression) -> Expression:
    """Return the ORI of a POSE."""
    expression = fold.numbers_of(expression)
    value = fold.pose_of(expression)
    if value is not None:
        return Constant(value[3:], ValueType.ORI)
    return Unary("orientation", expression, ValueType.ORI)


def is_location(value: Value) -> bool:
    """Return whether a value is a location for certain."""
    kind = known(value.type)
    return isinstance(kind, Type) and kind == POSE
