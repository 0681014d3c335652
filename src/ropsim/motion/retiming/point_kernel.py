"""What a timing lacks at the grid points that it is planned with, in loops that numba compiles."""

import math
from typing import NamedTuple

from ropsim.codegen import Array1, Array2, columns, kernel
from ropsim.motion.retiming.utilisation_kernel import (
    MOST_AT_ONCE,
    RATE,
    STEADY,
    SWING,
    SWING_SHARE,
    WINDOW,
    Derivatives,
)  # fmt: skip
from ropsim.spatial import Array

_TINY = 1e-300
_UNEVEN = 49.0
"""Greatest length of one part of a path over the other one where jerks next to it give that of its parts."""
WORK_ROWS = 12
BEFORE, HERE = 0, 1
"""Rows to work in: accelerations by real time at the point before and here."""
JERK_BEFORE, JERK_HERE, JERK_NEXT = 2, 3, 4
"""Mean jerks of the path by nominal time on the last interval but one, on the last one and on the next."""
FIRST_BEFORE, FIRST_HERE = 5, 6
"""First derivatives at the point before and here."""
MOST_SPEED, MOST_ACCELERATION, MOST_JERK = 7, 8, 9
"""Limits here."""
EXCESS, JERK = 10, 11
"""Results: the greatest excess, and the jerk by real time."""


class TimedPoints(NamedTuple):
    """Nominal time over real time at m points.

    Attributes:
        phi: nominal times [s], rising, shape (m,).
        times: real times there [s], rising, shape (m,).
        rates: dφ/dt there, shape (m,).
        changes: of the rates there [1/s], shape (m,).
    """

    phi: Array1
    times: Array1
    rates: Array1
    changes: Array1


class PointLimits(NamedTuple):
    """Limits of n joints and r paths.

    Attributes:
        speed: of the joints, and infinity for paths, shape (n + r,).
        acceleration: shape (m, n + r), or (1, n + r) for the same at all points.
        jerk: of the same shape.
    """

    speed: Array1
    acceleration: Array2
    jerk: Array2


@kernel
def lacks_at(
    path: Derivatives,
    timing: TimedPoints,
    limits: PointLimits,
    allowed: float,
    more: float,
    work: Array2,
    lacks: Array2,
    count: Array1,
) -> None:
    """Write lacks of n joints and r paths at m points, as `utilisation_of` at control ticks; torque aside.

    The jerk of an interval is the greater one of its two ends: its mean, and what the slope of the change of
    the rate has there beyond its own mean. Where the jerk of the path is between those of the neighbouring
    intervals, the path may have changed from the one to the other on the interval: then these count at its
    ends as well.

    Args:
        path: first and second derivatives by nominal time, shapes (m, n + r).
        timing: of the motion.
        limits: of joints and paths.
        allowed: what may be used of a limit, 1 and rounding.
        more: added to the logarithm of each excess.
        work: shape (WORK_ROWS, n + r).
        lacks: become logarithms of what rate and acceleration are to be divided by, windows to be multiplied
            with, and torque to be divided by, shape (4, m).
        count: becomes the number of excesses, shape (1,).
    """
    count[0] = 0.0
    first, second, rates, changes = path.first, path.second, timing.rates, timing.changes
    n, last, constant = first.shape[1], first.shape[0] - 1, limits.acceleration.shape[0] == 1
    lacks[:] = 0.0
    work[:] = 0.0
    per, begin, end = 0.0, 0.0, 0.0
    for i in range(last + 1):
        w, c, here, before = rates[i], changes[i], 0 if constant else i, max(i - 1, 0)
        v, b, square = rates[before], changes[before], w * w
        _next_point(work, n)
        _swing(n, square, c, first[i], second[i], work[HERE])
        if i < last:
            per = 1.0 / (timing.phi[i + 1] - timing.phi[i])
            _jerk(n, per, second[i + 1], second[i], work[JERK_NEXT])
        if i > 0:
            per = 1.0 / (timing.times[i] - timing.times[i - 1])
            mean, slope = (c - b) * per, 6.0 * (w - v) * per * per
            begin = slope - (4.0 * b + 2.0 * c) * per - mean
            end = (2.0 * b + 4.0 * c) * per - slope - mean
        cube = square * w if 1 < i < last else 0.0
        for j in range(n):
            work[FIRST_BEFORE, j], work[FIRST_HERE, j] = first[before, j], first[i, j]
            work[MOST_SPEED, j], work[MOST_JERK, j] = limits.speed[j], limits.jerk[here, j]
            work[MOST_ACCELERATION, j] = limits.acceleration[here, j]
        _exceed(n, allowed, w, cube, per, begin, end, work)
        for j in range(n):
            if not work[EXCESS, j] > 0.0:
                continue
            speed, acceleration, most = abs(first[i, j]) * w, abs(work[HERE, j]), work[JERK, j]
            if speed > allowed * limits.speed[j]:
                lack = math.log(min(speed / limits.speed[j], MOST_AT_ONCE)) + more
                _raise(lacks, RATE, i, lack, count)
            if acceleration > allowed * work[MOST_ACCELERATION, j]:
                lack = math.log(min(acceleration / work[MOST_ACCELERATION, j], MOST_AT_ONCE)) + more
                _raise(lacks, SWING, i, lack, count)
            if most > allowed * work[MOST_JERK, j]:
                by_path = abs(second[i, j] - second[before, j]) * square
                bend = abs(second[i, j] * (square - v * v)) + abs((first[i, j] - first[before, j]) * c)
                change = abs(first[i, j] * (c - b))
                whole = math.log(min(most / work[MOST_JERK, j], MOST_AT_ONCE)) + more
                whole /= max(by_path + bend + change, _TINY)
                for k in range(i - 1, i + 1):
                    _raise(lacks, RATE, k, by_path * STEADY * whole, count)
                    _raise(lacks, SWING, k, (bend + SWING_SHARE * change) * whole, count)
                    _raise(lacks, WINDOW, k, change * whole, count)


def _next_point(work: Array, count: int) -> None:
    """Let the accelerations and jerks of a point be those of the point before."""
    for j in range(count):
        work[BEFORE, j] = work[HERE, j]
        work[JERK_BEFORE, j] = work[JERK_HERE, j]
        work[JERK_HERE, j] = work[JERK_NEXT, j]


@columns
def _swing(count: int, square: float, c: float, first: Array, second: Array, out: Array) -> None:
    """Write accelerations by real time."""
    for j in range(count):
        out[j] = second[j] * square + first[j] * c


@columns
def _jerk(count: int, per: float, behind: Array, before: Array, out: Array) -> None:
    """Write mean jerks by nominal time on an interval."""
    for j in range(count):
        out[j] = (behind[j] - before[j]) * per


@columns
def _exceed(
    count: int, allowed: float, w: float, cube: float, per: float, begin: float, end: float, work: Array
) -> None:
    """Write the excess over limits at a point and on the interval to it, below 0 for none, and the jerk.

    Args:
        count: of joints and paths.
        allowed: what may be used of a limit.
        w: rate at the point.
        cube: its third power; 0 where no interval is before that to the point, or none behind it.
        per: inverse of the real time on the interval [1/s].
        begin: added to the jerk at its begin, for a first derivative of 1 [1/s²].
        end: the same at its end.
        work: rows as above.
    """
    for j in range(count):
        level = (work[HERE, j] - work[BEFORE, j]) * per
        start = level + work[FIRST_BEFORE, j] * begin
        stop = level + work[FIRST_HERE, j] * end
        rise = (work[JERK_NEXT, j] - work[JERK_HERE, j]) * cube
        fall = (work[JERK_BEFORE, j] - work[JERK_HERE, j]) * cube
        behind = max(min(rise, _UNEVEN * max(0.0 - fall, 0.0)), 0.0 - _UNEVEN * max(fall, 0.0))
        ahead = max(min(fall, _UNEVEN * max(0.0 - rise, 0.0)), 0.0 - _UNEVEN * max(rise, 0.0))
        at_start = max(abs(start), abs(start + ahead))
        at_stop = max(abs(stop), abs(stop + behind))
        far = max(at_start, at_stop)
        work[JERK, j] = far
        fast = abs(work[FIRST_HERE, j]) * w - allowed * work[MOST_SPEED, j]
        excess = max(fast, abs(work[HERE, j]) - allowed * work[MOST_ACCELERATION, j])
        work[EXCESS, j] = max(excess, far - allowed * work[MOST_JERK, j])


def _raise(lacks: Array, row: int, point: int, lack: float, result: Array) -> None:
    """Keep the greatest lack, and count it."""
    lacks[row, point] = max(lacks[row, point], lack)
    result[0] += 1.0
