"""Path limits along a bent path: the limits in its cells, in plain loops that numba compiles.

NaN stays NaN: a path that turns back in a point has NaN bounds.
"""

from math import sqrt

import numpy as np

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.planning.path_limits.derivative_bounds_kernel import (
    ACROSS,
    ALONG,
    D1,
    TINY,
    greater,
    lesser,
    speeds_within,
)
from ropsim.spatial import Array

MIXED = 0.5
"""Share of the jerk that a bend leaves along the path that is given up for changes of speed in the bend."""
ALIKE = (1.05, 1.5, 1.5)
"""Factors by which speed, acceleration and jerk of cells differ at most that are made one path limit."""


@kernel
def bent_limits(
    bounds: Array3,
    lengths: Array1,
    limits: Array2,
    share: float,
    level: float,
    most: Array1,
    speeds: Array1,
    cells: Array2,
    out: Array2,
    result: Array1,
) -> None:
    """Write the path limits along a bent path of k cells.

    With the derivatives d1, d2, d3 of the path by its length s: acceleration d2·v² + d1·a, jerk d3·v³ +
    3·d2·v·a + d1·j. Components along d1 add up; components across it are perpendicular to them.

    Args:
        bounds: of the derivatives, rows as in `bounds_of`, shape (5 or more, k, p).
        lengths: of the cells, shape (k,).
        limits: of speed, acceleration and jerk of the parts, shape (3, p).
        share: of the highest speed that bends allow, at which they are traversed at most.
        level: multiple of the mean of these speeds that is not exceeded anywhere.
        most: speeds that are not exceeded in the cells, shape (k,).
        speeds: work, shape (k,).
        cells: work, shape (k, 3).
        out: where length, speed, acceleration and jerk go, and the greatest of the last three in any cell of
            the path limit, shape (k, 7).
        result: output for their number, shape (1,).
    """
    speeds_within(bounds, limits, speeds)
    length = time = 0.0
    for i in range(bounds.shape[1]):
        slow = share * speeds[i]
        for part in range(bounds.shape[2]):
            slow = lesser(slow, limits[0, part] / greater(bounds[D1, i, part], TINY))
        speeds[i] = slow
        length += lengths[i]
        time += lengths[i] / slow
    for i in range(bounds.shape[1]):
        speeds[i] = lesser(lesser(speeds[i], level * length / time), most[i])
    _write_bounds(bounds, limits, speeds, cells)
    result[0] = _join_alike(lengths, cells, out)


@kernel
def straight_limits(
    length: float, d1: Array1, speed: Array1, acceleration: Array1, jerk: Array1, out: Array2
) -> None:
    """Write the path limit of a straight path of p parts.

    Args:
        length: of the path.
        d1: sizes of the first derivatives of the parts, the same everywhere, shape (p,).
        speed: limits of the parts, shape (p,).
        acceleration: its bounds.
        jerk: its bounds.
        out: where length, speed, acceleration and jerk go, shape (1, 4).
    """
    v, a, j = np.inf, np.inf, np.inf
    for part in range(d1.shape[0]):
        size = greater(d1[part], TINY)
        v = lesser(v, speed[part] / size)
        a = lesser(a, acceleration[part] / size)
        j = lesser(j, jerk[part] / size)
    out[0, 0], out[0, 1], out[0, 2], out[0, 3] = length, v, a, j


def _write_bounds(bounds: Array, limits: Array, speeds: Array, out: Array) -> None:
    """Write the speeds, accelerations and jerks along a path that hold together in k cells.

    Args:
        bounds: of the derivatives, rows as above, shape (5 or more, k, p).
        limits: of speed, acceleration and jerk of the parts, shape (3, p).
        speeds: with which the cells are traversed, shape (k,).
        out: where all three go, shape (k, 3).
    """
    for i in range(bounds.shape[1]):
        v, a, j = speeds[i], np.inf, np.inf
        cube = v * v * v
        for part in range(bounds.shape[2]):
            d1 = greater(bounds[D1, i, part], TINY)
            second, second_across = bounds[ALONG, i, part], bounds[ACROSS, i, part]
            most, jerk = limits[1, part], limits[2, part]
            along, across = bounds[ALONG + 1, i, part] * cube, bounds[ACROSS + 1, i, part] * cube
            bent = second_across * (v * v)
            remaining = sqrt(greater(most * most - bent * bent, 0.0)) - second * (v * v)
            left = MIXED * (sqrt(greater(jerk * jerk - across * across, 0.0)) - along)
            rest = sqrt(greater(jerk * jerk - (along + left) * (along + left), 0.0)) - across
            mixed = lesser(left / greater(second * v, TINY), rest / greater(second_across * v, TINY))
            a = lesser(a, lesser(remaining / d1, mixed / 3.0))
        for part in range(bounds.shape[2]):
            d1, jerk = greater(bounds[D1, i, part], TINY), limits[2, part]
            along, across = bounds[ALONG + 1, i, part] * cube, bounds[ACROSS + 1, i, part] * cube
            across += 3.0 * bounds[ACROSS, i, part] * v * a
            along += 3.0 * bounds[ALONG, i, part] * v * a
            j = lesser(j, (sqrt(greater(jerk * jerk - across * across, 0.0)) - along) / d1)
        out[i, 0], out[i, 1], out[i, 2] = v, a, j


def _join_alike(lengths: Array, bounds: Array, out: Array) -> int:
    """Write cells, of neighbours with similar bounds one, with the least of each bound.

    Args:
        lengths: of k cells, shape (k,).
        bounds: of their speeds, accelerations and jerks, shape (k, 3).
        out: where lengths and bounds go, then the greatest of the bounds, shape (k, 7).

    Returns:
        their number.
    """
    count = 0
    for i in range(lengths.shape[0]):
        row = count - 1
        alike = count > 0
        for kind in range(3):
            if alike:
                low = min(out[row, 1 + kind], bounds[i, kind])
                high = max(out[row, 4 + kind], bounds[i, kind])
                alike = high <= ALIKE[kind] * low
        if not alike:
            row = count
            count += 1
            out[row, 0] = 0.0
            for kind in range(3):
                out[row, 1 + kind] = out[row, 4 + kind] = bounds[i, kind]
        out[row, 0] += lengths[i]
        for kind in range(3):
            out[row, 1 + kind] = min(out[row, 1 + kind], bounds[i, kind])
            out[row, 4 + kind] = max(out[row, 4 + kind], bounds[i, kind])
    return count
