"""Motions in their motion time, and whether they clearly keep limits, in loops that numba compiles."""

import math

from ropsim.codegen import Array1, Array2, columns, kernel
from ropsim.spatial import Array

_ENDLESS = math.inf
AT_ONCE = 16
"""Ticks whose numbers are looked at as one row."""
WORST, REST, FIRST_LIMIT, ROWS_OF_WALK = 0, 1, 2, 5
"""Rows to work in: the most that was found of each column so far, zeros, and limits of all columns."""
MOST, ROWS_OF_LOAD = 1, 2
"""The same for torques: their limits are in the second row."""


@kernel
def walk_at(
    first: Array2, second: Array2, course: Array2, limits: Array2, room: Array2, out: Array2, beyond: Array1
) -> None:
    """Write speeds and accelerations at k control ticks, as `by_real_time` does, and what is beyond limits.

    Args:
        first: first derivatives by motion time, shape (k, n).
        second: second ones.
        course: motion times [s], rates w = dφ/dt, and their changes c [1/s], shape (3, k).
        limits: of speed, acceleration and change of acceleration in one tick, shape (3, n).
        room: to work in, shape (ROWS_OF_WALK, AT_ONCE·n).
        out: becomes q'·w and q''·w² + q'·c, shape (2, k·n).
        beyond: becomes the most by which one is beyond its limit, below 0 where all are kept, shape (1,).
    """
    n, ticks, speeds, swings = limits.shape[1], first.shape[0], out[0], out[1]
    for j in range(room.shape[1]):
        room[WORST, j], room[REST, j] = -_ENDLESS, 0.0
        for kind in range(limits.shape[0]):
            room[FIRST_LIMIT + kind, j] = limits[kind, j % n]
    begin, most = 0, -_ENDLESS
    while begin < ticks:
        end, at = min(begin + AT_ONCE, ticks) if begin else 1, begin * n
        for k in range(begin, end):
            w, c = course[1, k], course[2, k]
            _by_real_time(n, w, w * w, c, first[k], second[k], speeds[k * n :], swings[k * n :])
        before = swings[at - n :] if begin else room[REST]
        _beyond((end - begin) * n, speeds[at:], swings[at:], before, room)
        begin = end
    for j in range(room.shape[1]):
        most = max(most, room[WORST, j])
    for j in range(n):  # joints rest before the first and after the last tick
        most = max(most, abs(swings[ticks * n - n + j]) - limits[2, j])
    beyond[0] = most


@kernel
def beyond_torque(torque: Array1, limit: Array1, room: Array2, beyond: Array1) -> None:
    """Write the most by which torques of n joints at k control ticks are beyond their limits.

    Args:
        torque: of the joints [N m | N], shape (k·n,).
        limit: of each [N m | N], shape (n,).
        room: to work in, shape (ROWS_OF_LOAD, AT_ONCE·n).
        beyond: becomes the most, below 0 where all are kept; no number counts as infinity, shape (1,).
    """
    n = limit.shape[0]
    for j in range(room.shape[1]):
        room[WORST, j], room[MOST, j] = -_ENDLESS, limit[j % n]
    for begin in range(0, torque.shape[0], room.shape[1]):
        _load(min(room.shape[1], torque.shape[0] - begin), torque[begin:], room)
    most = -_ENDLESS
    for j in range(room.shape[1]):
        most = max(most, room[WORST, j])
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
def _beyond(count: int, speed: Array, swing: Array, before: Array, room: Array) -> None:
    """Keep the most by which speeds, accelerations and their changes are beyond limits."""
    for j in range(count):
        fast = min(_ENDLESS, abs(speed[j]) - room[FIRST_LIMIT, j])
        wild = min(_ENDLESS, abs(swing[j]) - room[FIRST_LIMIT + 1, j])
        jump = min(_ENDLESS, abs(swing[j] - before[j]) - room[FIRST_LIMIT + 2, j])
        steady = max(room[WORST, j], fast)
        changing = max(wild, jump)
        room[WORST, j] = max(steady, changing)


@columns
def _load(count: int, torque: Array, room: Array) -> None:
    """Keep the most by which torques are beyond their limits."""
    for j in range(count):
        room[WORST, j] = max(room[WORST, j], min(_ENDLESS, abs(torque[j]) - room[MOST, j]))
