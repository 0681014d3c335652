"""Where a motion of constant jerks is at given times, in a loop that numba compiles.

Segments stand in columns: path segment, time at the start [s], path parameter, speed, acceleration, jerk,
duration [s], path parameter at the end; see `TimeLaw`.
"""

from typing import NamedTuple

from ropsim.codegen import Array1, Array2, kernel
from ropsim.motion.time_law.law_times_kernel import start_of
from ropsim.spatial import Array

SIXTH = 1.0 / 6.0


class _Segment(NamedTuple):
    """A segment: number of its path segment, time and motion at its start, path parameter at its end."""

    number: float
    start: float
    s: float
    v: float
    a: float
    j: float
    end: float


@kernel
def rows_at(segments: Array2, duration: float, times: Array1, out: Array2) -> None:
    """Write path segment, path parameter, speed and acceleration at each time.

    Args:
        segments: shape (8, m).
        duration: time at which the last one ends [s].
        times: [s], best in order; those outside of the motion count as its start or end; shape (k,).
        out: where the rows go, shape (4, k or more).
    """
    last, row, k = segments.shape[1] - 1, 0, 0
    while k < times.shape[0]:
        t = max(times[k], 0.0)
        if t >= duration:
            out[0, k], out[1, k], out[2, k], out[3, k] = segments[0, last], segments[7, last], 0.0, 0.0
            k += 1
            continue
        row = _row_at(segments, t, row)
        start, until = segments[1, row], min(start_of(segments, row + 1), duration)
        end = k + 1
        while end < times.shape[0] and start <= max(times[end], 0.0) < until:
            end += 1
        s, v, a, j = segments[2, row], segments[3, row], segments[4, row], segments[5, row]
        _within(_Segment(segments[0, row], start, s, v, a, j, segments[7, row]), times, k, end, out)
        k = end


def _within(segment: _Segment, times: Array, first: int, until: int, out: Array) -> None:
    """Write the rows of times in one segment."""
    v, a, j = segment.v, segment.a, segment.j
    for k in range(first, until):
        u = max(times[k], 0.0) - segment.start
        out[0, k] = segment.number
        out[1, k] = min(segment.s + u * (v + u * (0.5 * a + u * (j * SIXTH))), segment.end)
        out[2, k] = max(v + u * (a + u * (0.5 * j)), 0.0)
        out[3, k] = a + u * j


def _row_at(segments: Array, t: float, row: int) -> int:
    """Return the last segment that starts no later than t, searched first at `row` and behind it."""
    m = segments.shape[1]
    if segments[1, row] <= t:
        if row + 1 == m or t < segments[1, row + 1]:
            return row
        if row + 2 == m or t < segments[1, row + 2]:
            return row + 1
        low, high = row + 2, m
    else:
        low, high = 0, row
    while high - low > 1:
        middle = (low + high) // 2
        if segments[1, middle] <= t:
            low = middle
        else:
            high = middle
    return low
