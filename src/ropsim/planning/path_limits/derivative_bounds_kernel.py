"""Bounds of a bent path cell by cell, and speeds that its bends allow, in plain loops that numba compiles.

NaN stays NaN: a path that turns back in a point has NaN bounds.
"""

from math import hypot, isnan, sqrt

import numpy as np

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.spatial import Array

UNIT = 1e-6
"""By which the size of a first derivative may differ from 1 that is 1 everywhere."""
CLOSE = 0.97
"""Cells are loose where bounds between path parameters cost more of the speed than the rest to 1."""
SHARE = 0.9
"""Of acceleration and of jerk that the bend alone may take; the rest is for changes of speed."""
TINY = 1e-150
"""Sizes below this count as this, so that nothing is divided by 0."""
D1, ALONG, ACROSS = 0, 1, 3
"""Rows of bounds: of the first derivative; of second and third along it; of these at right angles to it."""
SLOPE, CHANGE, START, END, SIZES = range(5)
"""Of third derivatives: mean in a cell, change of that to the next one, values at the ends of the two."""
SEEN = 5
"""First row of the values at the path parameters themselves, which are no bounds."""
HUGE = 1e100
"""Numbers below this have a third power; the cubic root of any is less than the square root of all above."""
APART = 0.999
"""Numbers are compared by their powers where one is by no more than this share of the other."""


@kernel
def bounds_of(
    s: Array1,
    d1: Array3,
    d2: Array3,
    limits: Array2,
    units: Array1,
    work: Array2,
    bounds: Array3,
    speeds: Array1,
    loose: Array1,
) -> None:
    """Write bounds of derivatives in the k cells between path parameters; see `derivative_bounds_of`.

    Args:
        s: path parameters, rising, shape (k + 1,), k >= 3.
        d1: first derivatives of p parts there, with c coordinates each, shape (k + 1, p, c).
        d2: second ones.
        limits: of speed, acceleration and jerk of the parts, shape (3, p).
        units: become 1 for parts whose first derivative has the size 1 at all path parameters, else 0, shape
            (p,).
        work: to work in, shape (k, c + `SIZES`).
        bounds: where they go, rows as above, shape (10, k, p).
        speeds: where the highest speeds go at which bends take no more than their share, shape (k,).
        loose: set to 1 where a bound costs speed that the evaluated values do not, else 0, shape (k,).
    """
    last, size = s.shape[0] - 2, d2.shape[2]
    for part in range(units.shape[0]):
        units[part] = _unit(d1, part)
    for part in range(units.shape[0]):
        if _stands(d1, d2, part):
            for row in range(bounds.shape[0]):
                for i in range(last + 1):
                    bounds[row, i, part] = 0.0
            continue
        _write_thirds(s, d2, part, work)
        unit = units[part]
        d1_here, d2_here = _size(d1[0, part]), _size(d2[0, part])
        for i in range(last + 1):
            h, steep = s[i + 1] - s[i], work[i, size + SLOPE]
            before, behind = max(i - 1, 0), min(i, last - 1)
            one, other = work[before, size + CHANGE], work[behind, size + CHANGE]
            off = 0.25 * h * greater(one, other)
            third = steep + h * greater(one / _span(s, before), other / _span(s, behind))
            if i <= last - 2:
                third = greater(third, work[i + 1, size + START])
            if i >= 2:
                third = greater(third, work[i - 2, size + END])
            if i == last - 1:
                third = greater(third, work[last, size + SLOPE])
            if i == 1:
                third = greater(third, work[0, size + SLOPE])
            d1_there, d2_there = _size(d1[i + 1, part]), _size(d2[i + 1, part])
            high, low = greater(d2_here, d2_there), lesser(d2_here, d2_there)
            first = greater(d1_here, d1_there)
            between = first if unit != 0.0 else first + 0.125 * h * h * third
            _split(bounds, 0, i, part, between, high + off, third, greater(low - off, 0.0), unit)
            _split(bounds, SEEN, i, part, first, high, steep, low, unit)
            d1_here, d2_here = d1_there, d2_there
    for i in range(last + 1):
        most = np.inf
        for part in range(units.shape[0]):
            most = lesser(most, limits[0, part] / greater(bounds[SEEN, i, part], TINY))
        speeds[i] = _fastest(bounds, 0, i, limits)
        costs = speeds[i] < CLOSE * most and _is_slower(speeds[i] / CLOSE, bounds, i, limits)
        loose[i] = 1.0 if costs else 0.0


@kernel
def speeds_within(bounds: Array3, limits: Array2, out: Array1) -> None:
    """Write the highest speeds at which bends take no more than their share in k cells.

    Args:
        bounds: of the derivatives, rows as above, shape (5 or more, k, p).
        limits: of speed, acceleration and jerk of the parts, shape (3, p).
        out: where they go, shape (k,).
    """
    for i in range(bounds.shape[1]):
        out[i] = _fastest(bounds, 0, i, limits)


def _unit(d1: Array, part: int) -> float:
    """Return 1.0 if the first derivative of a part has the size 1 at all path parameters, else 0.0."""
    for i in range(d1.shape[0]):
        if not abs(_size(d1[i, part]) - 1.0) <= UNIT:
            return 0.0
    return 1.0


def _stands(d1: Array, d2: Array, part: int) -> bool:
    """Return whether a part does not move at any path parameter."""
    for i in range(d1.shape[0]):
        for c in range(d1.shape[2]):
            if not (d1[i, part, c] == 0.0 and d2[i, part, c] == 0.0):
                return False
    return True


def _size(vector: Array) -> float:
    total = 0.0
    for c in range(vector.shape[0]):
        total += vector[c] * vector[c]
    return sqrt(total)


def _span(s: Array, i: int) -> float:
    """Return the length of a cell and the next one."""
    return float((s[i + 1] - s[i]) + (s[i + 2] - s[i + 1]))


def _write_thirds(s: Array, d2: Array, part: int, work: Array) -> None:
    """Write sizes of third derivatives, by the second ones at the ends of a cell and of the next one.

    Args:
        s: path parameters.
        d2: second derivatives.
        part: of the path.
        work: of each cell the mean third derivative, and behind its coordinates the four sizes as above.
    """
    last, size = s.shape[0] - 2, d2.shape[2]
    for i in range(last + 1):
        h, total = s[i + 1] - s[i], 0.0
        for c in range(size):
            value = (d2[i + 1, part, c] - d2[i, part, c]) / h
            work[i, c] = value
            total += value * value
        work[i, size + SLOPE] = sqrt(total)
    for i in range(last):
        h, k = s[i + 1] - s[i], s[i + 2] - s[i + 1]
        by_h, by_k = h / (h + k), k / (h + k)
        change = start = end_size = 0.0
        for c in range(size):
            value, behind = work[i, c], work[i + 1, c]
            grown = behind - value
            at_start, at_end = value - grown * by_h, behind + grown * by_k
            change += grown * grown
            start += at_start * at_start
            end_size += at_end * at_end
        work[i, size + CHANGE] = sqrt(change)
        work[i, size + START], work[i, size + END] = sqrt(start), sqrt(end_size)


def _split(
    bounds: Array,
    row: int,
    i: int,
    part: int,
    first: float,
    second: float,
    third: float,
    least: float,
    unit: float,
) -> None:
    """Write bounds by directions.

    Args:
        bounds: where they go.
        row: of the first of five.
        i: number of the cell.
        part: of the path.
        first: greatest size of the first derivative.
        second: of the second one.
        third: of the third one.
        least: least size of the second one.
        unit: 1.0 where the size of the first derivative of the part is 1 everywhere, else 0.0.
    """
    square = second * second
    rest = sqrt(greater(third * third - (least * least) * (least * least), 0.0))
    bounds[row + D1, i, part] = first
    if unit != 0.0:
        bounds[row + ALONG, i, part], bounds[row + ALONG + 1, i, part] = 0.0, square
        bounds[row + ACROSS, i, part], bounds[row + ACROSS + 1, i, part] = second, rest
    else:
        bounds[row + ALONG, i, part], bounds[row + ALONG + 1, i, part] = second, third
        bounds[row + ACROSS, i, part], bounds[row + ACROSS + 1, i, part] = 0.0, 0.0


def _fastest(bounds: Array, row: int, i: int, limits: Array) -> float:
    """Return the highest speed at which bends take no more than their share in a cell."""
    square, cube = _powers(bounds, row, i, limits)
    if cube < HUGE and square >= HUGE:
        return float(np.cbrt(cube))
    if cube < HUGE and square < HUGE:
        one, other = square * square * square, cube * cube
        if one < APART * other:
            return sqrt(square)
        if other < APART * one:
            return float(np.cbrt(cube))
    return lesser(sqrt(square), float(np.cbrt(cube)))


def _is_slower(speed: float, bounds: Array, i: int, limits: Array) -> bool:
    """Return whether a speed is below the highest one by the evaluated values of a cell; without roots."""
    square, cube = _powers(bounds, SEEN, i, limits)
    return speed * speed < square and speed * speed * speed < cube


def _powers(bounds: Array, row: int, i: int, limits: Array) -> tuple[float, float]:
    """Return square and cube of the speeds at which acceleration and jerk take no more than their share."""
    square, cube = np.inf, np.inf
    for part in range(bounds.shape[2]):
        second = _length(bounds[row + ALONG, i, part], bounds[row + ACROSS, i, part])
        third = _length(bounds[row + ALONG + 1, i, part], bounds[row + ACROSS + 1, i, part])
        square = lesser(square, SHARE * limits[1, part] / greater(second, TINY))
        cube = lesser(cube, SHARE * limits[2, part] / greater(third, TINY))
    return square, cube


def _length(along: float, across: float) -> float:
    """Return the length of a vector of two numbers, none of them below 0."""
    if along == 0.0 or across == 0.0:
        return along + across
    return hypot(along, across)


def greater(one: float, other: float) -> float:
    """Return the greater number; NaN stays NaN."""
    return one if one > other or isnan(one) else other


def lesser(one: float, other: float) -> float:
    """Return the lesser number; NaN stays NaN."""
    return one if one < other or isnan(one) else other
