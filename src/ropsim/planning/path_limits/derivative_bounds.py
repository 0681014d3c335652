"""How much a path bends: bounds of its derivatives by the path parameter, cell by cell."""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from ropsim.motion import JointMotionLimits
from ropsim.planning.path_limits.derivative_bounds_kernel import ACROSS, ALONG, D1, SIZES, bounds_of
from ropsim.spatial import Array, record

Look = Callable[[Array], tuple[Array, Array]]
"""Path parameters (k,) to first and second derivatives of p parts with c coordinates each, (k, p, c)."""

_ROUNDS = 6
"""How often cells are halved at most."""
_FEWEST = 9
"""Least number of evaluated path parameters."""


@record
class DerivativeBounds:
    """Bounds of the derivatives of p parts of a path in k cells, one after the other.

    The parts are position and orientation, or each joint. The size of a first derivative that is 1 everywhere
    stays 1, so that the second one is at right angles to it, and the third one has its square along it.
    Elsewhere all is taken as along it, which is the worst.

    Attributes:
        lengths: of the cells, in the unit of the path, shape (k,).
        table: sizes of the first derivatives, of the second and third ones along it, and of their components
            perpendicular to it, shape (5, k, p).
    """

    lengths: Array
    table: Array

    @property
    def d1(self) -> Array:
        """Return the sizes of the first derivatives, shape (k, p)."""
        return self.table[D1, :]

    @property
    def along(self) -> Array:
        """Return the sizes of the second and third derivatives along the first one, shape (2, k, p)."""
        return self.table[ALONG : ALONG + 2]

    @property
    def across(self) -> Array:
        """Return the sizes of the perpendicular components, shape (2, k, p)."""
        return self.table[ACROSS : ACROSS + 2]


def derivative_bounds_of(sample: Look, grid: Array, limits: JointMotionLimits) -> DerivativeBounds:
    """Return bounds that are close where the bend counts.

    Cells end at evaluated path parameters. A third derivative differs from its mean in a cell, given by the
    second ones at both ends, by no more than half the difference between neighbouring cells; on both sides of
    a jump it goes on as in the cells there. The second derivative leaves the straight line between both ends
    by at most a quarter of that difference over the cell. Cells in which these additions cost speed are
    halved.

    Args:
        sample: returns the derivatives.
        grid: path parameters from start to end, two or more, that are evaluated first; between them the path
            is smooth; shape (m,).
        limits: of the parts, each of shape (p,).
    """
    s = np.ascontiguousarray(grid, dtype=np.float64)
    while len(s) < _FEWEST:
        s = np.insert(s, np.arange(1, len(s)), 0.5 * (s[:-1] + s[1:]))
    d1, d2 = sample(s)
    rates = np.array((limits.speed, limits.acceleration, limits.jerk))
    for _ in range(_ROUNDS):
        found, cells = _bounds(s, d1, d2, rates)
        if len(cells) == 0:
            return found
        middles = 0.5 * (s[cells] + s[cells + 1])
        between = sample(middles)
        s = np.insert(s, cells + 1, middles)
        d1, d2 = (
            np.insert(rows, cells + 1, more, axis=0) for rows, more in zip((d1, d2), between, strict=True)
        )
    return _bounds(s, d1, d2, rates)[0]


def _bounds(s: Array, d1: Array, d2: Array, rates: Array) -> tuple[DerivativeBounds, npt.NDArray[np.intp]]:
    """Return bounds between path parameters, and the cells in which they are loose."""
    k, (_, parts, size) = len(s) - 1, d1.shape
    table, work, out = np.empty((10, k, parts)), np.empty((k, size + SIZES)), np.empty((2, k))
    rows = np.ascontiguousarray(d1), np.ascontiguousarray(d2)
    bounds_of(s, *rows, rates, np.empty(parts), work, table, out[0], out[1])
    return DerivativeBounds(np.diff(s), table[:5]), np.flatnonzero(out[1])
