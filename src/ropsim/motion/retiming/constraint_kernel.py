"""Constraint rows, and the rates that single points of a motion need, in loops that numba compiles."""

import math

from ropsim.codegen import Array1, Array2, kernel
from ropsim.motion.retiming.utilisation_kernel import ACCELERATION, JERK, SPEED, TORQUE
from ropsim.spatial import Array

_CREEP = 0.02
"""Share of the speed of joints at which dry friction is as in motion and nothing else counts."""
_TINY = 2.0**-1022


@kernel
def creeping(d1: Array2, speed: Array1, out: Array2) -> None:
    """Write the speeds of joints that creep, a small share of their limits and of their greatest speeds.

    Args:
        d1: derivatives of joint coordinates by nominal time, shape (m, n).
        speed: limits of the joints, shape (n,).
        out: becomes the speeds, shape (m, n), m >= 1.
    """
    m, n = d1.shape
    for j in range(n):
        out[0, j] = 0.0
        for i in range(m):
            out[0, j] = max(out[0, j], abs(d1[i, j]))
        out[0, j] = min(speed[j], out[0, j] + _TINY)
    for i in range(m - 1, -1, -1):
        share = _CREEP
        for j in range(n):
            share = max(share, abs(d1[i, j]) / out[0, j])
        for j in range(n):
            out[i, j] = d1[i, j] * (_CREEP / share)


_TINY = 1e-300


@kernel
def rates_within(
    d1: Array2, d2: Array2, grid_phi: Array1, inverse: Array2, period: float, out: Array1
) -> None:
    """Write the constant rates, at most 1, at which the joints just keep their limits of speed and jerk.

    With the rate w, speeds scale by w and jerk by w³; where acceleration is not steady, its step in one
    control tick by w². Jerk counts at both ends of a path.

    Args:
        d1: first derivatives by nominal time, shape (m, n).
        d2: second ones, shape (m, n).
        grid_phi: nominal times [s], rising, shape (m,).
        inverse: of the limits of speed and jerk, shape (2, n).
        period: of the control ticks [s].
        out: becomes the rates, shape (m,).
    """
    last, before = d1.shape[0] - 1, 1.0
    for i in range(last + 1):
        fast, step = 1.0, 0.0
        for j in range(d1.shape[1]):
            fast = max(fast, abs(d1[i, j]) * inverse[0, j])
        rate = 1.0 / fast if fast > 1.0 else 1.0
        for j in range(d1.shape[1] if i < last else 0):
            step = max(step, abs(d2[i + 1, j] - d2[i, j]) * inverse[1, j])
        behind = 1.0
        if i < last and step > grid_phi[i + 1] - grid_phi[i] and step > period:
            lasting, sudden = (grid_phi[i + 1] - grid_phi[i]) / step, period / step
            behind = max(lasting ** (1.0 / 3.0), math.sqrt(sudden))
        out[i] = min(rate, behind, before)
        before = behind


@kernel
def least_rate(
    d1: Array2,
    d2: Array2,
    torque: Array2,
    still: Array2,
    grid_phi: Array1,
    limits: Array2,
    period: float,
    begin: int,
    end: int,
    out: Array1,
) -> None:
    """Write which limit of which joint needs the lowest rate; see `binding_constraint`.

    Args:
        d1: first derivatives by nominal time, shape (m, n).
        d2: second ones, shape (m, n).
        torque: of the plan from grid point `begin` on [N m | N], shape (end - begin, n), or (…, 0).
        still: torque of creeping at all grid points [N m | N], shape (m, n), or (m, 0).
        grid_phi: nominal times [s], shape (m,).
        limits: in the order of `Quantity`, shape (4, n).
        period: of the control ticks [s].
        begin: first checked grid point.
        end: grid point behind the last one.
        out: becomes the quantity, the grid point, the joint and the rate, shape (4,).
    """
    out[3] = math.inf
    last = d1.shape[0] - 1
    for j in range(d1.shape[1]):
        for i in range(begin, end):
            fast, swing = max(abs(d1[i, j]), _TINY), max(abs(d2[i, j]), _TINY)
            if limits[SPEED, j] < out[3] * fast:
                _lower(out, SPEED, i, j, limits[SPEED, j] / fast)
            if limits[ACCELERATION, j] < out[3] * out[3] * swing:
                _lower(out, ACCELERATION, i, j, math.sqrt(limits[ACCELERATION, j] / swing))
        for i in range(max(begin - 1, 0), min(end, last)):
            step, jerk, square = max(abs(d2[i + 1, j] - d2[i, j]), _TINY), limits[JERK, j], out[3] * out[3]
            interval = grid_phi[i + 1] - grid_phi[i]
            if jerk * interval < square * out[3] * step and jerk * period < square * step:
                share = jerk / step
                rate = max((share * interval) ** (1.0 / 3.0), math.sqrt(share * period))
                _lower(out, JERK, max(i, begin), j, rate)
        for i in range(begin, end if j < torque.shape[1] else begin):
            held = still[i, j]
            moved = torque[i - begin, j] - held
            free = max(limits[TORQUE, j] + (held if moved < 0.0 else -held), 0.0)
            most = max(abs(moved), _TINY)
            if free < out[3] * out[3] * most:
                _lower(out, TORQUE, i, j, math.sqrt(free / most))


def _lower(out: Array, kind: int, point: int, joint: int, rate: float) -> None:
    """Keep a rate with its constraint if it is lower than the present one."""
    if rate < out[3]:
        out[0], out[1], out[2], out[3] = kind, point, joint, rate
