"""What joints allow along a path at ticks at which they cannot follow, in loops that numba compiles."""

from math import sqrt
from typing import NamedTuple

import numpy as np

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.spatial import Array

MOST_AT_ONCE = 0.5
"""Least share of what a path asks of a joint that is left at once."""
GREAT = 0.02
"""Least share that a part must have in a sum to be brought down for it."""
OWN = 0.5
"""A path with a greater share in a sum than this, but in no part of it, is traversed slower as a whole."""
SPEED, ACCELERATION, JERK = range(3)
"""Kinds of bounds along a path; rows of limits, too."""
TORQUE = 3
"""Number of the quantity, and row of the limits."""


class AlongPath(NamedTuple):
    """Motion along a path at the ticks before b ticks, then at the b ticks.

    Attributes:
        speeds: along the path, shape (2·b,).
        accelerations: of the same shape.
        jerks: behind each of these times, of the same shape.
        d1: first derivatives of the joints by the path parameter, shape (2·b, n).
        d2: second ones.
    """

    speeds: Array1
    accelerations: Array1
    jerks: Array1
    d1: Array2
    d2: Array2


class OfJoints(NamedTuple):
    """Motion and torque of n joints at b ticks.

    Attributes:
        qd: speeds of all motions that go on [rad/s | m/s], shape (b, n).
        qdd: accelerations at the ticks before and at the ticks, shape (2, b, n).
        loads: torques, their part with the square of the speed along the path, and their part with the
            acceleration along the path [N m | N], shape (3, b, n), or (3, 0, n).
    """

    qd: Array2
    qdd: Array3
    loads: Array3


@kernel
def limits_imposed(
    path: AlongPath,
    joints: OfJoints,
    limits: Array2,
    period: float,
    used: float,
    allowed: float,
    imposed: Array2,
    count: Array1,
) -> None:
    """Write the limits that joints impose along a path: of speed, acceleration, jerk, then torque.

    Of each quantity those of speed come first, then of acceleration, then of jerk along the path. Beside
    another motion that counts as if it went on for all of a tick in which it begins or ends: with less of it
    it lasts longer, and into ticks that the other one fills.

    Args:
        path: motion along it.
        joints: at the ticks.
        limits: of speed, acceleration, change of acceleration in a tick, and torque, shape (4, n).
        period: of the ticks [s].
        used: share of the limits that is aimed at.
        allowed: what may be used of a limit, 1 and rounding.
        imposed: where they go: kind, value, number of the tick, joint, quantity, of at least shape (5,
            5·b·n).
        count: becomes their number, shape (1 or more,).
    """
    speeds, accelerations, jerks, d1, d2 = path
    qd, qdd, loads = joints
    b = qd.shape[0]
    last = _of_speed(speeds, qd, limits, used, allowed, imposed)
    spare = imposed.shape[1] - b * qd.shape[1]
    for quantity in range(ACCELERATION, TORQUE + 1):
        found = 0
        for k in range(loads.shape[1] if quantity == TORQUE else b):
            for j in range(qd.shape[1]):
                value, limit = qdd[1, k, j], limits[quantity, j]
                if quantity == TORQUE:
                    value = loads[0, k, j]
                elif quantity == JERK:
                    value -= qdd[0, k, j]
                if not abs(value) > limit * allowed:
                    continue
                v0, v, a0, a = speeds[k], speeds[b + k], accelerations[k], accelerations[b + k]
                bent, along, third = d2[b + k, j] * (v * v), d1[b + k, j] * a, 0.0
                if quantity == TORQUE:
                    bent, along = loads[1, k, j], loads[2, k, j]
                elif quantity == JERK:
                    bent = (d2[b + k, j] - d2[k, j]) * 0.5 * (v * v + v0 * v0)
                    along = 0.5 * (
                        (d2[b + k, j] + d2[k, j]) * (v * v - v0 * v0) + (d1[b + k, j] - d1[k, j]) * (a + a0)
                    )
                    third = 0.5 * (d1[b + k, j] + d1[k, j]) * (a - a0)
                kind, size = _greatest(value, bent, along, third)
                if kind < 0:
                    continue
                whole, aim = abs(value), used * limit
                own = whole if quantity == TORQUE else (bent + along + third) * (1.0 if value > 0.0 else -1.0)
                jerk = abs(a - a0) / period
                if quantity == JERK and kind == JERK and own < (1.0 - GREAT) * whole:
                    jerk = max(abs(jerks[k]), abs(jerks[b + k]), jerk)
                    full = max(0.5 * abs(d1[b + k, j] + d1[k, j]) * jerk * period, size)
                    whole, own, size = whole + full - size, own + full - size, full
                share = max(1.0 - _excess(whole, own, aim) / size, MOST_AT_ONCE)
                if quantity != JERK:
                    cap = v * sqrt(share) if kind == SPEED else abs(a) * share
                elif kind == SPEED:
                    cap = v * np.cbrt(share)
                elif kind == ACCELERATION:
                    cap = max(abs(a0), abs(a), abs((v - v0) / period)) * share
                else:
                    cap = jerk * share
                _add(imposed, spare + found, kind, cap, k, j, quantity)
                found += 1
        last = _in_order(imposed, spare, found, last)
    count[0] = last


def _of_speed(speeds: Array, qd: Array, limits: Array, used: float, allowed: float, imposed: Array) -> int:
    count = 0
    for k in range(qd.shape[0]):
        for j in range(qd.shape[1]):
            limit, speed = limits[SPEED, j], abs(qd[k, j])
            if speed > limit * allowed:
                cap = speeds[qd.shape[0] + k] * max(used * limit / speed, MOST_AT_ONCE)
                count = _add(imposed, count, SPEED, cap, k, j, SPEED)
    return count


def _greatest(value: float, bent: float, along: float, third: float) -> tuple[int, float]:
    """Return the greatest part of a value that is too much.

    Returns:
        its number and how great it is; 0 and the whole where none is great, -1 where the value is that of
        another motion.
    """
    sign, whole = 1.0 if value > 0.0 else -1.0, abs(value)
    part, size, total = 0, bent * sign, bent * sign + along * sign + third * sign
    if along * sign > size:
        part, size = 1, along * sign
    if third * sign > size:
        part, size = 2, third * sign
    if size < GREAT * whole:
        return (0, whole) if total > OWN * whole else (-1, 0.0)
    return part, size


def _excess(whole: float, own: float, aim: float) -> float:
    """Return by how much a path is to come down for a value that is too much, and of which it has a part.

    With nearly all of the value it takes all of the excess, with less of it as much of the excess.
    """
    mine = max(own / whole, 0.0)
    return max(whole - aim, 0.0) * (mine if mine < 1.0 - GREAT else 1.0)


def _in_order(imposed: Array, first: int, found: int, count: int) -> int:
    """Write caps again, by their kinds, behind `count` others; return the number of all."""
    for kind in range(3):
        for h in range(first, first + found):
            if imposed[0, h] == kind:
                for row in range(imposed.shape[0]):
                    imposed[row, count] = imposed[row, h]
                count += 1
    return count


def _add(imposed: Array, count: int, kind: int, value: float, row: int, joint: int, quantity: int) -> int:
    """Write a cap; return the number of all."""
    imposed[0, count], imposed[1, count], imposed[2, count] = kind, value, row
    imposed[3, count], imposed[4, count] = joint, quantity
    return count + 1
