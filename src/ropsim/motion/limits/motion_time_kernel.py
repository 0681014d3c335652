"""Motion time over real time, in loops that numba compiles."""

import math

from ropsim.codegen import Array1, Array2, columns, kernel
from ropsim.spatial import Array

_INSIDE = 0.9
"""Share of a rate by which it may change towards a third of a cell, so that it stays above 0 in between.

The mean rate is then at least (2 - share)/2 of that at the ends, and a cell lasts so much longer at most.
"""


@kernel
def motion_time_at(
    knots: Array1, places: Array1, rates: Array1, changes: Array1, times: Array1, out: Array2
) -> None:
    """Write motion time [s], its rate and the change of that [1/s] at real times; see `MotionTime.at`.

    Args:
        knots: real times of the knots [s], rising, shape (m,), m >= 2.
        places: motion times there [s], shape (m,).
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
        ends = knots[0], knots[last], knots[i], places[i], places[i + 1], places[last]
        cubic = first, change, square, cube, square * (1.0 / 3.0)
        phi, rate, rise = out[0, begin:], out[1, begin:], out[2, begin:]
        _in_cell(end - begin, *ends, *cubic, times[begin:], phi, rate, rise)
        begin = end


@columns
def _in_cell(
    count: int,
    lowest: float,
    highest: float,
    knot: float,
    place: float,
    behind: float,
    whole: float,
    first: float,
    change: float,
    square: float,
    cube: float,
    third: float,
    times: Array,
    phi: Array,
    rate: Array,
    rise: Array,
) -> None:
    """Write motion time, its rate and the change of that at times between two knots."""
    for j in range(count):
        t = min(max(times[j], lowest), highest)
        past = t - knot
        way = past * (first + past * (change / 2.0 + past * (third + past * cube / 4.0)))
        here = min(max(place + way, place), behind)
        phi[j] = here if t < highest else whole
        rate[j] = first + past * (change + past * (square + past * cube))
        rise[j] = change + past * (2.0 * square + past * 3.0 * cube)


@kernel
def timed(places: Array1, rates: Array1, changes: Array1, times: Array1) -> None:
    """Write the real times at which a motion with given rates comes to its knots; see `motion_time`.

    Args:
        places: motion times of the knots [s], rising, shape (m,), m >= 2.
        rates: in ]0, 1], shape (m,).
        changes: d²φ/dt² [1/s]; those that would lead a rate out of ]0, 1] are brought down, shape (m,).
        times: become real times [s], from 0 on, shape (m,).
    """
    last = places.shape[0] - 1
    left = (rates[1] + rates[0]) / 2.0 / (places[1] - places[0])
    way, mean, before = 0.0, 1.0, 0.0
    for i in range(last + 1):
        right = left
        if i < last:
            right = (rates[i + 1] + rates[i]) / 2.0 / (places[i + 1] - places[i])
        above, below = 3.0 * (1.0 - rates[i]), 3.0 * _INSIDE * rates[i] * (2.0 - _INSIDE) / 2.0
        up, down = min(above * right, below * left), min(above * left, below * right)
        changes[i] = min(max(changes[i], -down), up)
        if i == 0:
            times[0] = 0.0
        else:
            bend = (before - changes[i]) / 12.0
            root = math.sqrt(max(mean * mean + 4.0 * bend * way, 0.0))
            times[i] = times[i - 1] + 2.0 * way / (mean + root)
        if i < last:
            way, mean = places[i + 1] - places[i], (rates[i + 1] + rates[i]) / 2.0
        before, left = changes[i], right
