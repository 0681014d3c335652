"""Orientations: two directions in files, where prismatic pairs slide along x; quaternions in the model."""

from collections.abc import Sequence
from math import inf, nextafter, sqrt

from ropsim.model import JointType
from ropsim.spatial import Pose, quaternion

Vector = tuple[float, float, float]
Columns = tuple[Vector, Vector, Vector]
"""The axes x, y, z of a frame in another one."""

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
_NEAR = 4e-16  # distance from -1, 0 and 1 that is rounding
_SCALES = 400  # lengths that are tried, by a billionth each
_SQUARE = 1e-12  # sine below which two directions are parallel


def columns_of(axis: Vector, reference: Vector) -> Columns | None:
    """Return the axes of the frame of a placement (ISO 10303-42); nothing where its directions are parallel.

    Args:
        axis: direction of z, of any length.
        reference: direction from which x follows: its part across z.
    """
    z = _unit(axis)
    along = _dot(reference, z)
    across = (
        tuple(r - along * a for r, a in zip(reference, z, strict=True))
        if along
        else tuple(float(r) for r in reference)
    )
    length = sqrt(_dot(across, across))
    if not length > _SQUARE * sqrt(_dot(reference, reference)):
        return None
    x = _unit(across)
    y = (z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0])
    return x, y, z


def moved_frame(columns: Columns, type_: JointType) -> Columns:
    """Return the frame whose z axis is that of the motion, from the one that a pair is placed with."""
    x, y, z = columns
    return (y, z, x) if type_ is JointType.PRISMATIC else columns


def placed_frame(columns: Columns, type_: JointType) -> Columns:
    """Return the frame that a pair is placed with, from the one whose z axis is that of the motion."""
    x, y, z = columns
    return (z, x, y) if type_ is JointType.PRISMATIC else columns


def quaternion_of(columns: Columns) -> quaternion.Quaternion:
    """Return the orientation of a frame as a unit quaternion (w, x, y, z)."""
    x, y, z = columns
    return quaternion.from_rotation(tuple(zip(x, y, z, strict=True)))


def columns_of_pose(pose: Pose) -> Columns:
    """Return the axes of the frame of a pose; components are rounded to 0 or ±1 within the rounding error."""
    R = pose.rotation().tolist()
    x, y, z = (tuple(_snapped(R[row][column]) for row in range(3)) for column in range(3))
    return _vector(x), _vector(y), _vector(z)


def exact_quaternion(pose: Pose) -> quaternion.Quaternion:
    """Return numbers from which the very bits of an orientation come out again when they are normalized."""
    w, x, y, z = pose.orientation.tolist()
    for step in range(_SCALES):
        scale = 1.0 + step * 1e-9
        found = (w * scale, x * scale, y * scale, z * scale)
        for moved in (found, *(_next(found, place) for place in range(4))):
            if quaternion.normalize(moved) == (w, x, y, z):
                return moved
    return (w, x, y, z)


def _next(q: quaternion.Quaternion, place: int) -> quaternion.Quaternion:
    w, x, y, z = (nextafter(one, inf) if k == place else one for k, one in enumerate(q))
    return (w, x, y, z)


def _snapped(value: float) -> float:
    nearest = float(round(value))
    return nearest if abs(value - nearest) < _NEAR else float(value)


def _unit(vector: Sequence[float]) -> Vector:
    """Return a vector of length 1; a vector with length 1 within rounding keeps its bits."""
    largest = max(map(abs, vector))
    scaled = [one / largest for one in vector] if largest > 1e100 or largest < 1e-100 else list(vector)
    square = _dot(scaled, scaled)
    if abs(square - 1.0) < _NEAR:
        return _vector(scaled)
    length = sqrt(square)
    return _vector([one / length for one in scaled])


def _vector(values: Sequence[float]) -> Vector:
    x, y, z = values
    return (x, y, z)


def _dot(one: Sequence[float], other: Sequence[float]) -> float:
    return sum(a * b for a, b in zip(one, other, strict=True))
