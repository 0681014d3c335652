"""Arc: the TCP on a circle through three points, as far as the last one or by an angle."""

import math
from dataclasses import field
from enum import Enum

import numpy as np

from ropsim.model import OrientationMode
from ropsim.motion.curves.path import FARTHEST, STANDS, ToolPoints
from ropsim.motion.paths.orientation import ToolTurn, tool_turn
from ropsim.motion.paths.turn import Turn
from ropsim.spatial import Array, Pose, frozen, record

_FLATTEST = 1e4  # greatest radius by the longest side of the triangle; the arc is 12 µm off a line of 1 m


class ArcOrientation(Enum):
    """Orientation of the tool on an arc."""

    TO_THE_END = "from the orientation of the start to that of the end, evenly over the way"
    WITH_THE_ARC = "as it stands to the tangent and the plane of the arc at the start"


class ArcFault(Enum):
    """Why there is no arc through three points."""

    NOT_FINITE = "a coordinate or the angle is not a number, or no robot is that large"
    END_AT_START = "start and end are one point"
    VIA_AT_START = "start and via point are one point"
    VIA_AT_END = "via point and end are one point"
    COLLINEAR = "the three points lie on one line"
    NO_ANGLE = "the angle is not positive"


@record
class Arc:
    """p(φ) = start + radius·(sin φ·tangent + (1 - cos φ)·inward) for φ = s / radius.

    So it begins at the start exactly, and arcs that are nearly straight lose no accuracy by a far centre.

    Attributes:
        start: first point in the reference frame [m], shape (3,).
        tangent: unit vector along the path at the start, shape (3,).
        inward: unit vector from the start to the centre, shape (3,).
        radius: [m].
        angle: of the path about the centre [rad]; positive, may exceed 2π.
        turn: orientation over the share of the path.
        length: of the path [m].
    """

    start: Array
    tangent: Array
    inward: Array
    radius: float
    angle: float
    turn: ToolTurn
    length: float = field(init=False)

    def __post_init__(self) -> None:
        for name in ("start", "tangent", "inward"):
            object.__setattr__(self, name, frozen(getattr(self, name)))
        object.__setattr__(self, "length", self.radius * self.angle)

    @property
    def moves(self) -> bool:
        """Return that the TCP moves: the path parameter is its arc length."""
        return True

    def tool(self, s: Array) -> ToolPoints:
        """Return the tool and its derivatives at path parameters s, shape (k,)."""
        share = 1.0 / self.length
        angles = s / self.radius
        turned = self.turn.at(s * share)
        sines, cosines = np.sin(angles)[:, None], np.cos(angles)[:, None]
        matrices = np.zeros((len(s), 4, 4))
        matrices[:, :3, :3] = turned.rotations
        matrices[:, :3, 3] = self._at(angles)
        matrices[:, 3, 3] = 1.0
        d1, d2 = np.empty((len(s), 6)), np.empty((len(s), 6))
        d1[:, :3] = cosines * self.tangent + sines * self.inward
        d1[:, 3:] = turned.d1 * share
        d2[:, :3] = (cosines * self.inward - sines * self.tangent) / self.radius
        d2[:, 3:] = turned.d2 * (share * share)
        return ToolPoints(matrices, d1, d2)

    def positions(self, s: Array) -> Array:
        """Return where the TCP is at path parameters s, shape (k,) to (k, 3) [m]."""
        return self._at(s / self.radius)

    def distance(self, points: Array) -> Array:
        """Return how far points, shape (k, 3) [m], are from the path of the TCP, shape (k,) [m]."""
        offsets = points - self.start
        along, inward = offsets @ self.tangent, offsets @ self.inward - self.radius  # from the centre
        height = offsets @ _cross(self.tangent, self.inward)
        from_circle = np.hypot(np.hypot(along, inward) - self.radius, height)
        # where the circle does not reach that far round, one of the ends is nearest
        from_ends = np.min(
            [np.linalg.norm(points - end, axis=1) for end in self._at(np.array([0.0, self.angle]))], axis=0
        )
        angles = np.arctan2(along, -inward) % (2.0 * math.pi)
        return np.asarray(np.where(angles <= self.angle, from_circle, from_ends))

    def _at(self, angles: Array) -> Array:
        versines = 2.0 * np.square(np.sin(angles / 2.0))
        offsets = np.sin(angles)[:, None] * self.tangent + versines[:, None] * self.inward
        return np.asarray(self.start + self.radius * offsets)


def arc(
    X_start: Pose,
    X_via: Pose,
    X_end: Pose,
    orientation: ArcOrientation = ArcOrientation.TO_THE_END,
    mode: OrientationMode = OrientationMode.FIXED_AXIS,
    angle: float | None = None,
) -> Arc | ArcFault:
    """Return the arc from a start through a via point, or why there is none.

    The three points determine circle and sense; the orientation at the via point does not count.

    Args:
        X_start: at path parameter 0 in the reference frame.
        X_via: on the way; only its position.
        X_end: at the end; with an angle a third point of the circle, and the orientation where the path ends.
        orientation: orientation mode; with the arc it does not take the orientation of the end.
        mode: how the tool turns to the orientation of the end.
        angle: how far to go about the centre [rad], over the end and round again; as far as the end if None.
    """
    points = [pose.position for pose in (X_start, X_via, X_end)]
    if not (np.abs([*points, np.full(3, angle or 0.0)]) <= FARTHEST).all():  # NaN is not either
        return ArcFault.NOT_FINITE
    if angle is not None and angle <= 0.0:
        return ArcFault.NO_ANGLE
    start, via, end = points
    to_via, to_end = via - start, end - start
    sides = [float(np.linalg.norm(side)) for side in (to_end, to_via, end - via)]
    for side, fault in zip(sides, _COINCIDENT, strict=True):
        if side <= STANDS:
            return fault
    normal = _cross(to_via, to_end)
    area = float(np.linalg.norm(normal))  # twice that of the triangle
    if math.prod(sides) >= 2.0 * area * _FLATTEST * max(sides):
        return ArcFault.COLLINEAR
    axis = normal / area
    to_centre = sides[1] ** 2 * _cross(to_end, axis) + sides[0] ** 2 * _cross(axis, to_via)  # times 2·area
    inward = to_centre / np.linalg.norm(to_centre)
    tangent = _cross(inward, axis)
    if angle is None:
        angle = 2.0 * math.atan2(float(to_end @ inward), float(to_end @ tangent))
    turn = tool_turn(X_start, X_end, mode)
    if orientation is ArcOrientation.WITH_THE_ARC:
        turn = ToolTurn(turn.R_start, Turn(turn.R_start.T @ axis, angle))
    return Arc(start, tangent, inward, math.prod(sides) / (2.0 * area), angle, turn)


def _cross(a: Array, b: Array) -> Array:
    """Return a × b, shapes (3,)."""
    ax, ay, az = a.tolist()
    bx, by, bz = b.tolist()
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])


_COINCIDENT = (ArcFault.END_AT_START, ArcFault.VIA_AT_START, ArcFault.VIA_AT_END)
