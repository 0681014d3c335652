"""How much a path bends: bounds of its derivatives by the place, cell by cell."""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from ropsim.motion import JointMotionLimits
from ropsim.spatial import Array, record

Look = Callable[[Array], tuple[Array, Array]]
"""From places (k,) to the first and second derivatives of p parts with c coordinates each, (k, p, c)."""

_FEWEST = 9
"""Places that are looked at, at least."""
_ROUNDS = 6
"""How often cells are halved at most."""
_CLOSE = 0.97
"""Cells are halved where bounds of what lies between places cost more of the speed than the rest to 1."""
_UNIT = 1e-6
"""By which the size of a first derivative may differ from 1 that is 1 everywhere."""
_SHARE = 0.9
"""Of acceleration and of jerk that the bend alone may take; the rest is for changes of speed."""
TINY = 1e-150
"""Sizes below this count as this, so that nothing is divided by 0."""


@record
class Bends:
    """Bounds of the derivatives of p parts of a path in k cells, one after the other.

    The parts are position and orientation, or each joint. The size of a first derivative that is 1 everywhere
    stays 1, so that the second one is at right angles to it, and the third one has its square along it.
    Elsewhere all is taken as along it, which is the worst.

    Attributes:
        lengths: of the cells, in the unit of the path, shape (k,).
        d1: sizes of the first derivatives, shape (k, p).
        along: sizes of the second and third derivatives along the first one, shape (2, k, p).
        across: sizes of what is at right angles to it, shape (2, k, p).
    """

    lengths: Array
    d1: Array
    along: Array
    across: Array


def bends_of(look: Look, grid: Array, limits: JointMotionLimits) -> Bends:
    """Return bounds that are close where the bend counts.

    Cells end at places that are looked at. A third derivative differs from its mean in a cell, told by the
    second ones at both ends, by no more than half of what those of neighbours differ by; on both sides of a
    jump it goes on as in the cells there. The second derivative leaves the straight line between both ends by
    at most a quarter of that difference over the cell. Cells in which these additions cost speed are halved.

    Args:
        look: gives the derivatives.
        grid: places from start to end, two or more, that are looked at first; between them the path is
            smooth; shape (m,).
        limits: of the parts, each of shape (p,).
    """
    s = grid
    while len(s) < _FEWEST:
        s = np.insert(s, np.arange(1, len(s)), 0.5 * (s[:-1] + s[1:]))
    d1, d2 = look(s)
    for _ in range(_ROUNDS):
        found, least = _bounds(s, d1, d2)
        fastest = (limits.speed / np.maximum(least.d1, TINY)).min(axis=1)
        wanted = np.minimum(fastest, bent_speeds(least, limits))
        loose = bent_speeds(found, limits) < _CLOSE * wanted
        cells = np.flatnonzero(loose)
        if len(cells) == 0:
            return found
        middles = 0.5 * (s[cells] + s[cells + 1])
        between = look(middles)
        s = np.insert(s, cells + 1, middles)
        d1, d2 = (
            np.insert(rows, cells + 1, more, axis=0) for rows, more in zip((d1, d2), between, strict=True)
        )
    return _bounds(s, d1, d2)[0]


def bent_speeds(bends: Bends, limits: JointMotionLimits) -> Array:
    """Return the highest speeds at which bends take no more than their share in the cells, shape (k,).

    Args:
        bends: of the path.
        limits: of the parts, each of shape (p,).
    """
    second, third = (np.hypot(*both) for both in zip(bends.along, bends.across, strict=True))
    by_acceleration = np.sqrt(_SHARE * limits.acceleration / np.maximum(second, TINY))
    by_jerk = np.cbrt(_SHARE * limits.jerk / np.maximum(third, TINY))
    return np.asarray(np.minimum(by_acceleration, by_jerk).min(axis=1))


def _bounds(s: Array, d1: Array, d2: Array) -> tuple[Bends, Bends]:
    """Return bounds of what lies between places, and those of what was seen at the places."""
    h = np.diff(s)[:, None]
    sizes, bent = _sizes(d1), _sizes(d2)
    slopes = np.diff(d2, axis=0) / h[:, :, None]
    changes = np.diff(slopes, axis=0)
    steep, change = _sizes(slopes), _sizes(changes)
    span = h[:-1] + h[1:]
    third = steep + h * np.maximum(*_beside(change / span))
    start = _sizes(slopes[:-1] - changes * (h[:-1] / span)[:, :, None])  # of cells, as it goes on
    end = _sizes(slopes[1:] + changes * (h[1:] / span)[:, :, None])
    third[:-2] = np.maximum(third[:-2], start[1:])
    third[2:] = np.maximum(third[2:], end[:-1])
    third[-2], third[1] = np.maximum(third[-2], steep[-1]), np.maximum(third[1], steep[0])
    off = 0.25 * h * np.maximum(*_beside(change))
    high, low = np.maximum(bent[:-1], bent[1:]), np.minimum(bent[:-1], bent[1:])
    first = np.maximum(sizes[:-1], sizes[1:])
    unit = np.max(np.abs(sizes - 1.0), axis=0) <= _UNIT
    between = np.where(unit, first, first + 0.125 * h * h * third)
    found = _split(h[:, 0], between, high + off, third, np.maximum(low - off, 0.0), unit)
    return found, _split(h[:, 0], first, high, steep, low, unit)


def _sizes(rows: Array) -> Array:
    """Return the sizes of vectors, (k, p, c) to (k, p)."""
    return np.asarray(np.sqrt(np.add.reduce(rows * rows, axis=2)))


def _beside(between: Array) -> tuple[Array, Array]:
    """Return for each cell what lies between it and the one before, and the one behind: (k - 1, p) to (k, p).

    The first and the last cell have one neighbour.
    """
    return np.concatenate((between[:1], between)), np.concatenate((between, between[-1:]))


def _split(
    lengths: Array, first: Array, second: Array, third: Array, least: Array, unit: npt.NDArray[np.bool_]
) -> Bends:
    """Return bounds by directions.

    Args:
        lengths: of the cells, shape (k,).
        first: greatest sizes of the first derivatives, shape (k, p).
        second: of the second ones.
        third: of the third ones.
        least: least sizes of the second ones.
        unit: whether the size of the first derivative of a part is 1 everywhere, shape (p,).
    """
    square = second * second
    rest = np.sqrt(np.maximum(third * third - (least * least) ** 2, 0.0))
    along = np.stack((np.where(unit, 0.0, second), np.where(unit, square, third)))
    across = np.stack((np.where(unit, second, 0.0), np.where(unit, rest, 0.0)))
    return Bends(lengths, first, along, across)
