"""Points in a frame of their own in which they are about as long as wide as high: thin ones become sound."""

import numpy as np

from ropsim.collision.polytope import far_points
from ropsim.spatial import Array, frozen, record

FINE = 1e-9
"""Points thinner than this share of the size count as flat."""


@record
class UnitPoints:
    """Points stretched to 1 along three axes, with additional apexes where they are flat.

    A hull of few corners is sound only where its body is no sliver. The axes are defined by four points far
    from each other, so that thin plates, needles and slender triangles become bodies about as thick as long.

    Attributes:
        points: the given ones, and behind them two apexes for each axis without extent, shape (k, 3).
        given: how many were given.
        scale: extent along each axis, of an axis without extent the size [m], shape (3,).
        size: largest extent [m].
    """

    points: Array
    given: int
    scale: Array
    size: float

    def __post_init__(self) -> None:
        object.__setattr__(self, "points", frozen(self.points))
        object.__setattr__(self, "scale", frozen(self.scale))


def unit_points(points: Array) -> UnitPoints | None:
    """Return points in their frame; None where all are one.

    Args:
        points: [m], shape (k, 3).
    """
    first, second, third, _ = far_points(points)
    along = _unit(second - first)
    if not along.any():
        return None
    side = _unit(_across(_across(third - first, along), along))
    if not side.any():
        side = _unit(_across(np.eye(3)[int(np.argmin(np.abs(along)))], along))
    local = (points - first) @ np.column_stack([along, side, np.cross(along, side)])
    extent = np.ptp(local, axis=0)
    size = float(extent.max())
    flat = extent <= FINE * size
    scale = np.where(flat, size, extent)
    middle = (local.min(axis=0) + local.max(axis=0)) / 2.0
    apexes = np.eye(3)[flat]
    return UnitPoints(np.vstack([(local - middle) / scale, apexes, -apexes]), len(points), scale, size)


def _across(vector: Array, unit: Array) -> Array:
    """Return the component of a vector perpendicular to a unit vector."""
    return np.asarray(vector - (vector @ unit) * unit)


def _unit(vector: Array) -> Array:
    """Return the unit vector along a vector; zero for zero."""
    largest = float(np.abs(vector).max())
    if not largest > 0.0:
        return np.zeros(3)
    return np.asarray(vector / largest / np.linalg.norm(vector / largest))
