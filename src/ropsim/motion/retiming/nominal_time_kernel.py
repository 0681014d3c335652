"""Nominal time over real time, and motions in it, in loops that numba compiles."""

import math
from typing import NamedTuple

from ropsim.codegen import Array1, Array2, columns, kernel
from ropsim.spatial import Array

_INSIDE = 0.9
"""Share of a rate by which it may change towards a third of a cell, so that it stays above 0 in between.

The mean rate is then at least (2 - share)/2 of that at the ends, and a cell lasts longer by at most that
factor.
"""


class _Knots(NamedTuple):
    """Ends of all knots, and of the cell between two of them.

    Attributes:
        lowest: real time of the first knot [s].
        highest: real time of the last knot [s].
        whole: nominal time at the last knot [s].
        begin: real time at the begin of the cell [s].
        start: nominal time at the begin of the cell [s].
        end: nominal time at the end of the cell [s].
    """

    lowest: float
    highest: float
    whole: float
    begin: float
    start: float
    end: float


class _Cubic(NamedTuple):
    """The rate in a cell, as coefficients of powers of the real time since its begin."""

    rate: float
    change: float
    square: float
    cube: float


@kernel
def motion_time_at(
    knots: Array1, phi: Array1, rates: Array1, changes: Array1, times: Array1, out: Array2
) -> None:
    """Write nominal time [s], its rate and the change of that [1/s] at real times; see `NominalTime.at`.

    Args:
        knots: real times of the knots [s], rising, shape (m,), m >= 2.
        phi: nominal times there [s], shape (m,).
        rates: there, shape (m,).
        changes: of the rates there [1/s], shape (m,).
        times: real times [s], best in order, shape (k,).
        out: where the answers go, shape (3, k).
    """
    last, i, begin = knots.shape[0] - 1, 0, 0
    while begin < times.shape[0]:
        t = times[begin]
        if t < knots[i]:
            i = 0
        while i < last - 1 and knots[i + 1] <= t:
            i += 1
        end, until = begin + 1, knots[i + 1] if i < last - 1 else math.inf
        while end < times.shape[0] and knots[i] <= times[end] < until:
            end += 1
        per = 1.0 / (knots[i + 1] - knots[i])
        first, change, then = rates[i], changes[i], changes[i + 1]
        more = (rates[i + 1] - first) * per
        square = (3.0 * more - 2.0 * change - then) * per
        cube = (change + then - 2.0 * more) * (per * per)
        ends = _Knots(knots[0], knots[last], phi[last], knots[i], phi[i], phi[i + 1])
        _in_cell(ends, _Cubic(first, change, square, cube), times[begin:end], out[:, begin:end])
        begin = end


def _in_cell(ends: _Knots, cubic: _Cubic, times: Array, out: Array) -> None:
    """Write nominal time, its rate and the change of that at times between two knots."""
    third = cubic.square * (1.0 / 3.0)
    for j in range(times.shape[0]):
        t = min(max(times[j], ends.lowest), ends.highest)
        past = t - ends.begin
        increase = past * (
            cubic.rate + past * (cubic.change / 2.0 + past * (third + past * cubic.cube / 4.0))
        )
        here = min(max(ends.start + increase, ends.start), ends.end)
        out[0, j] = here if t < ends.highest else ends.whole
        out[1, j] = cubic.rate + past * (cubic.change + past * (cubic.square + past * cubic.cube))
        out[2, j] = cubic.change + past * (2.0 * cubic.square + past * 3.0 * cubic.cube)


@kernel
def timed(phi: Array1, rates: Array1, changes: Array1, times: Array1) -> None:
    """Write the real times at which a motion with given rates comes to its knots; see `motion_time`.

    Args:
        phi: nominal times of the knots [s], rising, shape (m,), m >= 2.
        rates: in ]0, 1], shape (m,).
        changes: d²φ/dt² [1/s]; changes that would lead a rate out of ]0, 1] are reduced, shape (m,).
        times: become real times [s], from 0 on, shape (m,).
    """
    last = phi.shape[0] - 1
    left = (rates[1] + rates[0]) / 2.0 / (phi[1] - phi[0])
    interval, mean, before = 0.0, 1.0, 0.0
    for i in range(last + 1):
        right = left
        if i < last:
            right = (rates[i + 1] + rates[i]) / 2.0 / (phi[i + 1] - phi[i])
        above, below = 3.0 * (1.0 - rates[i]), 3.0 * _INSIDE * rates[i] * (2.0 - _INSIDE) / 2.0
        up, down = min(above * right, below * left), min(above * left, below * right)
        changes[i] = min(max(changes[i], -down), up)
        if i == 0:
            times[0] = 0.0
        else:
            bend = (before - changes[i]) / 12.0
            root = math.sqrt(max(mean * mean + 4.0 * bend * interval, 0.0))
            times[i] = times[i - 1] + 2.0 * interval / (mean + root)
        if i < last:
            interval, mean = phi[i + 1] - phi[i], (rates[i + 1] + rates[i]) / 2.0
        before, left = changes[i], right


_ENDLESS = math.inf
AT_ONCE = 16
"""Ticks whose numbers are processed as one row."""
WORST, REST, FIRST_LIMIT, ROWS_OF_RATES = 0, 1, 2, 5
"""Rows to work in: the most that was found of each column so far, zeros, and limits of all columns."""
MOST, ROWS_OF_LOAD = 1, 2
"""The same for torques: their limits are in the second row."""


@kernel
def evaluate_at(
    first: Array2, second: Array2, timing: Array2, limits: Array2, work: Array2, out: Array2, beyond: Array1
) -> None:
    """Write speeds and accelerations by real time at k control ticks, and excesses over limits.

    Args:
        first: first derivatives by nominal time, shape (k, n).
        second: second ones.
        timing: nominal times [s], rates w = dφ/dt, and their changes c [1/s], shape (3, k).
        limits: of speed, acceleration and change of acceleration in one tick, shape (3, n).
        work: to work in, shape (ROWS_OF_RATES, AT_ONCE·n).
        out: becomes q'·w and q''·w² + q'·c, shape (2, k·n).
        beyond: becomes the most by which one is beyond its limit, below 0 where all are kept, shape (1,).
    """
    n, ticks, speeds, swings = limits.shape[1], first.shape[0], out[0], out[1]
    for j in range(work.shape[1]):
        work[WORST, j], work[REST, j] = -_ENDLESS, 0.0
        for kind in range(limits.shape[0]):
            work[FIRST_LIMIT + kind, j] = limits[kind, j % n]
    begin, most = 0, -_ENDLESS
    while begin < ticks:
        end, at = min(begin + AT_ONCE, ticks) if begin else 1, begin * n
        for k in range(begin, end):
            w, c = timing[1, k], timing[2, k]
            _by_real_time(n, w, w * w, c, first[k], second[k], speeds[k * n :], swings[k * n :])
        before = swings[at - n :] if begin else work[REST]
        _beyond((end - begin) * n, speeds[at:], swings[at:], before, work)
        begin = end
    for j in range(work.shape[1]):
        most = max(most, work[WORST, j])
    for j in range(n):  # joints rest before the first and after the last tick
        most = max(most, abs(swings[ticks * n - n + j]) - limits[2, j])
    beyond[0] = most


@kernel
def beyond_torque(torque: Array1, limit: Array1, work: Array2, beyond: Array1) -> None:
    """Write the most by which torques of n joints at k control ticks are beyond their limits.

    Args:
        torque: of the joints [N m | N], shape (k·n,).
        limit: of each [N m | N], shape (n,).
        work: to work in, shape (ROWS_OF_LOAD, AT_ONCE·n).
        beyond: becomes the most, below 0 where all are kept; no number counts as infinity, shape (1,).
    """
    n = limit.shape[0]
    for j in range(work.shape[1]):
        work[WORST, j], work[MOST, j] = -_ENDLESS, limit[j % n]
    for begin in range(0, torque.shape[0], work.shape[1]):
        _load(min(work.shape[1], torque.shape[0] - begin), torque[begin:], work)
    most = -_ENDLESS
    for j in range(work.shape[1]):
        most = max(most, work[WORST, j])
    beyond[0] = most


@columns
def _by_real_time(
    count: int, w: float, square: float, c: float, first: Array, second: Array, speed: Array, swing: Array
) -> None:
    """Write speeds and accelerations at a tick."""
    for j in range(count):
        speed[j] = first[j] * w
        swing[j] = second[j] * square + first[j] * c


@columns
def _beyond(count: int, speed: Array, swing: Array, before: Array, work: Array) -> None:
    """Keep the most by which speeds, accelerations and their changes are beyond limits."""
    for j in range(count):
        fast = min(_ENDLESS, abs(speed[j]) - work[FIRST_LIMIT, j])
        wild = min(_ENDLESS, abs(swing[j]) - work[FIRST_LIMIT + 1, j])
        jump = min(_ENDLESS, abs(swing[j] - before[j]) - work[FIRST_LIMIT + 2, j])
        steady = max(work[WORST, j], fast)
        changing = max(wild, jump)
        work[WORST, j] = max(steady, changing)


@columns
def _load(count: int, torque: Array, work: Array) -> None:
    """Keep the most by which torques are beyond their limits."""
    for j in range(count):
        work[WORST, j] = max(work[WORST, j], min(_ENDLESS, abs(torque[j]) - work[MOST, j]))
