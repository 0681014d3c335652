"""Bounds of a bent path cell by cell, and speeds that its bends allow, in plain loops that numba compiles.

What is no number stays none: a path that turns back in a point has such bounds.
"""

from math import hypot, isnan, sqrt

import numpy as np

from ropsim.codegen import kernel
from ropsim.spatial import Array

UNIT = 1e-6
"""By which the size of a first derivative may differ from 1 that is 1 everywhere."""
CLOSE = 0.97
"""Cells are loose where bounds of what lies between places cost more of the speed than the rest to 1."""
SHARE = 0.9
"""Of acceleration and of jerk that the bend alone may take; the rest is for changes of speed."""
TINY = 1e-150
"""Sizes below this count as this, so that nothing is divided by 0."""
D1, ALONG, ACROSS = 0, 1, 3
"""Rows of bounds: of the first derivative; of second and third along it; of these at right angles to it."""
SLOPE, CHANGE, START, END = range(4)
"""Of third derivatives: mean in a cell, change of that to the next one, values at the ends of the two."""
SEEN = 5
"""First row of the same as it was seen at the places, which is no bound."""


@kernel("void(f8[::1], f8[:,:,::1], f8[:,:,::1], f8[:,::1], f8[:,:,::1], f8[::1])")
def bounds_of(s: Array, d1: Array, d2: Array, limits: Array, bounds: Array, loose: Array) -> None:
    """Write bounds of derivatives in the k cells between places; see `bends_of`.

    Args:
        s: places, rising, shape (k + 1,), k >= 3.
        d1: first derivatives of p parts there, with c coordinates each, shape (k + 1, p, c).
        d2: second ones.
        limits: of speed, acceleration and jerk of the parts, shape (3, p).
        bounds: where they go, rows as above, shape (10, k, p).
        loose: becomes 1 where a bound costs speed that what was seen does not, else 0, shape (k,).
    """
    last = s.shape[0] - 2
    for part in range(d1.shape[1]):
        unit = 1
        for i in range(last + 2):
            if not abs(_size(d1[i, part]) - 1.0) <= UNIT:
                unit = 0
        for i in range(last + 1):
            h, steep = s[i + 1] - s[i], _third(s, d2, part, i, SLOPE)
            before, behind = max(i - 1, 0), min(i, last - 1)
            one, other = _third(s, d2, part, before, CHANGE), _third(s, d2, part, behind, CHANGE)
            off = 0.25 * h * _greater(one, other)
            third = steep + h * _greater(one / _span(s, before), other / _span(s, behind))
            if i <= last - 2:
                third = _greater(third, _third(s, d2, part, i + 1, START))
            if i >= 2:
                third = _greater(third, _third(s, d2, part, i - 2, END))
            if i == last - 1:
                third = _greater(third, _third(s, d2, part, last, SLOPE))
            if i == 1:
                third = _greater(third, _third(s, d2, part, 0, SLOPE))
            one, other = _size(d2[i, part]), _size(d2[i + 1, part])
            high, low = _greater(one, other), _lesser(one, other)
            first = _greater(_size(d1[i, part]), _size(d1[i + 1, part]))
            between = first if unit else first + 0.125 * h * h * third
            _split(bounds, 0, i, part, between, high + off, third, _greater(low - off, 0.0), unit)
            _split(bounds, SEEN, i, part, first, high, steep, low, unit)
    for i in range(last + 1):
        wanted = _fastest(bounds, SEEN, i, limits)
        for part in range(d1.shape[1]):
            wanted = _lesser(wanted, limits[0, part] / _greater(bounds[SEEN, i, part], TINY))
        loose[i] = 1.0 if _fastest(bounds, 0, i, limits) < CLOSE * wanted else 0.0


@kernel("void(f8[:,:,::1], f8[:,::1], f8[::1])")
def bend_speeds(bounds: Array, limits: Array, out: Array) -> None:
    """Write the highest speeds at which bends take no more than their share in k cells.

    Args:
        bounds: of the derivatives, rows as above, shape (5 or more, k, p).
        limits: of speed, acceleration and jerk of the parts, shape (3, p).
        out: where they go, shape (k,).
    """
    for i in range(bounds.shape[1]):
        out[i] = _fastest(bounds, 0, i, limits)


def _size(vector: Array) -> float:
    total = 0.0
    for c in range(vector.shape[0]):
        total += vector[c] * vector[c]
    return sqrt(total)


def _span(s: Array, i: int) -> float:
    """Return the length of a cell and the next one."""
    return float((s[i + 1] - s[i]) + (s[i + 2] - s[i + 1]))


def _third(s: Array, d2: Array, part: int, i: int, which: int) -> float:
    """Return a size of the third derivative by the second ones at the ends of a cell and of the next one."""
    h, total = s[i + 1] - s[i], 0.0
    for c in range(d2.shape[2]):
        value = (d2[i + 1, part, c] - d2[i, part, c]) / h
        if which != SLOPE:
            k = s[i + 2] - s[i + 1]
            behind = (d2[i + 2, part, c] - d2[i + 1, part, c]) / k
            change = behind - value
            if which == CHANGE:
                value = change
            elif which == START:
                value -= change * (h / (h + k))
            else:
                value = behind + change * (k / (h + k))
        total += value * value
    return sqrt(total)


def _split(
    bounds: Array,
    row: int,
    i: int,
    part: int,
    first: float,
    second: float,
    third: float,
    least: float,
    unit: int,
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
        unit: 1 where the size of the first derivative of the part is 1 everywhere, else 0.
    """
    square = second * second
    rest = sqrt(_greater(third * third - (least * least) * (least * least), 0.0))
    bounds[row + D1, i, part] = first
    if unit:
        bounds[row + ALONG, i, part], bounds[row + ALONG + 1, i, part] = 0.0, square
        bounds[row + ACROSS, i, part], bounds[row + ACROSS + 1, i, part] = second, rest
    else:
        bounds[row + ALONG, i, part], bounds[row + ALONG + 1, i, part] = second, third
        bounds[row + ACROSS, i, part], bounds[row + ACROSS + 1, i, part] = 0.0, 0.0


def _fastest(bounds: Array, row: int, i: int, limits: Array) -> float:
    """Return the highest speed at which bends take no more than their share in a cell."""
    speed = np.inf
    for part in range(bounds.shape[2]):
        second = hypot(bounds[row + ALONG, i, part], bounds[row + ACROSS, i, part])
        third = hypot(bounds[row + ALONG + 1, i, part], bounds[row + ACROSS + 1, i, part])
        by_acceleration = sqrt(SHARE * limits[1, part] / _greater(second, TINY))
        by_jerk = np.cbrt(SHARE * limits[2, part] / _greater(third, TINY))
        speed = _lesser(speed, _lesser(by_acceleration, by_jerk))
    return float(speed)


def _greater(one: float, other: float) -> float:
    """Return the greater number; what is none stays."""
    return one if one > other or isnan(one) else other


def _lesser(one: float, other: float) -> float:
    """Return the lesser number; what is none stays."""
    return one if one < other or isnan(one) else other
