"""Motions in their motion time, and whether they clearly keep limits, in loops that numba compiles."""

import math

from ropsim.codegen import columns, kernel
from ropsim.spatial import Array

_ENDLESS = math.inf
AT_ONCE = 16
"""Rows of torques that are looked at as one."""
WORST, HERE = range(2)
"""Rows to work in: the most that was found of each column so far, and zeros or limits of all columns."""


@kernel("void(f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,:,::1], f8[::1])")
def walk_at(
    first: Array, second: Array, course: Array, limits: Array, room: Array, out: Array, beyond: Array
) -> None:
    """Write speeds and accelerations at k control ticks, as `by_real_time` does, and what is beyond limits.

    Args:
        first: first derivatives by motion time, shape (k, n).
        second: second ones.
        course: motion times [s], rates w = dφ/dt, and their changes c [1/s], shape (3, k).
        limits: of speed, acceleration and change of acceleration in one tick, shape (3, n).
        room: to work in, shape (2, n).
        out: becomes q'·w and q''·w² + q'·c, shape (2, k, n).
        beyond: becomes the most by which one is beyond its limit, below 0 where all are kept, shape (1,).
    """
    n, last = limits.shape[1], first.shape[0] - 1
    for j in range(n):
        room[WORST, j], room[HERE, j] = -_ENDLESS, 0.0
    before = room[HERE]  # joints rest before the first and after the last tick
    for k in range(last + 1):
        w, c = course[1, k], course[2, k]
        _walk(n, w, w * w, c, first[k], second[k], before, limits, out[0, k], out[1, k], room)
        before = out[1, k]
    most = -_ENDLESS
    for j in range(n):
        most = max(most, room[WORST, j], abs(out[1, last, j]) - limits[2, j])
    beyond[0] = most


@kernel("void(f8[::1], f8[::1], f8[:,::1], f8[::1])")
def beyond_torque(torque: Array, limit: Array, room: Array, beyond: Array) -> None:
    """Write the most by which torques of n joints at k control ticks are beyond their limits.

    Args:
        torque: of the joints [N m | N], shape (k·n,).
        limit: of each [N m | N], shape (n,).
        room: to work in, shape (2, AT_ONCE·n).
        beyond: becomes the most, below 0 where all are kept; no number counts as infinity, shape (1,).
    """
    n = limit.shape[0]
    for j in range(room.shape[1]):
        room[WORST, j], room[HERE, j] = -_ENDLESS, limit[j % n]
    for begin in range(0, torque.shape[0], room.shape[1]):
        _load(min(room.shape[1], torque.shape[0] - begin), torque[begin:], room)
    most = -_ENDLESS
    for j in range(room.shape[1]):
        most = max(most, room[WORST, j])
    beyond[0] = most


@columns
def _walk(
    count: int,
    w: float,
    square: float,
    c: float,
    first: Array,
    second: Array,
    before: Array,
    limits: Array,
    speed: Array,
    swing: Array,
    room: Array,
) -> None:
    """Write speeds and accelerations at a tick, and keep the most that is beyond limits."""
    for j in range(count):
        v = first[j] * w
        a = second[j] * square + first[j] * c
        speed[j] = v
        swing[j] = a
        fast = min(_ENDLESS, abs(v) - limits[0, j])
        wild = min(_ENDLESS, abs(a) - limits[1, j])
        jump = min(_ENDLESS, abs(a - before[j]) - limits[2, j])
        steady = max(room[0, j], fast)
        changing = max(wild, jump)
        room[0, j] = max(steady, changing)


@columns
def _load(count: int, torque: Array, room: Array) -> None:
    """Keep the most by which torques are beyond their limits."""
    for j in range(count):
        room[0, j] = max(room[0, j], min(_ENDLESS, abs(torque[j]) - room[1, j]))
