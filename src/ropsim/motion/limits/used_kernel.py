"""What a motion uses of the limits at its control ticks, in loops that numba compiles."""

import math

from ropsim.codegen import Array1, Array2, columns, kernel
from ropsim.motion.limits.strain_kernel import ACCELERATION, JERK, SPEED, TORQUE
from ropsim.spatial import Array

ENDLESS = math.inf
AT_ONCE = 16
"""Ticks whose numbers are looked at as one row."""
ROWS_OF_MOTION, ROWS_OF_TORQUE = 7, 2
"""Rows to work in: reciprocals of limits of all columns, what is used of them, and zeros."""
REST = 6
"""Row of zeros: joints rest before the first and after the last tick."""


@kernel
def used_by_motion(
    qd: Array1, qdd: Array1, limits: Array2, room: Array2, used: Array2, peaks: Array1
) -> None:
    """Compute what n joints use of speed, acceleration and jerk at k control ticks, as `strain_of` does.

    Args:
        qd: speeds [rad/s | m/s], shape (k·n,).
        qdd: accelerations [rad/s² | m/s²], shape (k·n,).
        limits: of speed, acceleration and change of acceleration in one tick, shape (3, n).
        room: to work in, shape (ROWS_OF_MOTION, AT_ONCE·n).
        used: becomes what is used by the joint that uses most, in its first three rows, shape (4, k).
        peaks: becomes the most of each, in its first three numbers, shape (4,).
    """
    n, ticks = limits.shape[1], used.shape[1]
    for k in range(AT_ONCE):
        for j in range(n):
            room[0, k * n + j], room[1, k * n + j] = 1.0 / limits[0, j], 1.0 / limits[1, j]
            room[2, k * n + j], room[REST, k * n + j] = 1.0 / limits[2, j], 0.0
    begin, most_speed, most_acceleration, most_jerk = 0, 0.0, 0.0, 0.0
    while begin < ticks:
        end = min(begin + AT_ONCE, ticks) if begin else 1
        first, count = begin * n, (end - begin) * n
        before = qdd[first - n :] if begin else room[REST]
        _motion_shares(count, qd[first:], qdd[first:], before, room)
        for k in range(begin, end):
            speed, acceleration, jerk = 0.0, 0.0, 0.0
            for j in range((k - begin) * n, (k - begin + 1) * n):
                speed = max(speed, room[3, j])
                acceleration = max(acceleration, room[4, j])
                jerk = max(jerk, room[5, j])
            if k == ticks - 1:
                _motion_shares(n, qd[k * n :], qdd[k * n :], room[REST], room)
                for j in range(n):
                    jerk = max(jerk, room[5, j])
            used[SPEED, k], used[ACCELERATION, k], used[JERK, k] = speed, acceleration, jerk
            most_speed = max(most_speed, speed)
            most_acceleration = max(most_acceleration, acceleration)
            most_jerk = max(most_jerk, jerk)
        begin = end
    peaks[SPEED], peaks[ACCELERATION], peaks[JERK] = most_speed, most_acceleration, most_jerk


@kernel
def used_by_torque(torque: Array1, limit: Array1, room: Array2, used: Array2, peaks: Array1) -> None:
    """Compute what n joints use of their torque at k control ticks, as `strain_of` does.

    Args:
        torque: of the joints [N m | N], shape (k·n,).
        limit: of each [N m | N], shape (n,).
        room: to work in, shape (ROWS_OF_TORQUE, AT_ONCE·n).
        used: its last row becomes what is used by the joint that uses most, shape (4, k).
        peaks: its last number becomes the most of that, shape (4,).
    """
    n, ticks, peak = limit.shape[0], used.shape[1], 0.0
    for k in range(AT_ONCE):
        for j in range(n):
            room[0, k * n + j] = 1.0 / limit[j]
    for begin in range(0, ticks, AT_ONCE):
        end = min(begin + AT_ONCE, ticks)
        _torque_shares((end - begin) * n, torque[begin * n :], room)
        for k in range(begin, end):
            most = 0.0
            for j in range((k - begin) * n, (k - begin + 1) * n):
                most = max(most, room[1, j])
            used[TORQUE, k] = most
            peak = max(peak, most)
    peaks[TORQUE] = peak


@columns
def _motion_shares(count: int, qd: Array, qdd: Array, before: Array, room: Array) -> None:
    """Write what is used of limits of speed, acceleration and jerk; no number counts as infinity."""
    for j in range(count):
        room[3, j] = min(ENDLESS, abs(qd[j]) * room[0, j])
        room[4, j] = min(ENDLESS, abs(qdd[j]) * room[1, j])
        room[5, j] = min(ENDLESS, abs(qdd[j] - before[j]) * room[2, j])


@columns
def _torque_shares(count: int, torque: Array, room: Array) -> None:
    """Write what is used of limits of torque."""
    for j in range(count):
        room[1, j] = min(ENDLESS, abs(torque[j]) * room[0, j])
