"""Places of a motion, as dense as it must be slow there."""

import math

import numpy as np

from ropsim.codegen import Array1, Array2, kernel
from ropsim.motion.curves.path import JointPoints
from ropsim.motion.retiming.joint_bounds import JointBounds
from ropsim.motion.retiming.retimed import Motion
from ropsim.spatial import Array

_FEWEST = 8
_ROUNDS = 12
_LEAST_PART = 1e-4
"""PathMotion that are shorter than this share of the grid are not divided further."""
_LONG = 1.5
"""Greatest real time between two grid points, over the requested time."""
_LITTLE_LONGER = 1.03
"""The same where nominal time is slower: with 1.5, arms with much jerk lose up to 7 % on single motions."""
_STEEP = 0.4
"""Greatest change of the logarithm of the speed that a joint allows, from grid point to grid point."""
_MOST_PARTS = 64.0


def grid_points_of(
    motion: Motion, bounds: JointBounds, spacing: float, phi: Array, rates: Array
) -> tuple[Array, JointPoints]:
    """Return nominal times [s] from 0 to the end, about one real time apart, (m,), and the motion there.

    Where joints must go far, or the speed that they allow changes steeply, intervals are divided.

    Args:
        motion: the plan.
        bounds: of the joints.
        spacing: real time between two grid points [s].
        phi: nominal times at which rates are known, rising, shape (k,).
        rates: estimates of dφ/dt there, in ]0, 1], shape (k,).
    """
    count = max(int(np.ceil(motion.duration / spacing)), _FEWEST)
    grid_phi, parts = np.linspace(0.0, motion.duration, count + 1), np.empty(count)
    parts_by_rate(grid_phi, np.ascontiguousarray(phi), np.ascontiguousarray(rates), parts)
    for _ in range(_ROUNDS):
        grid_phi = _divided(grid_phi, parts)
        points, parts = motion.at(grid_phi), np.empty(len(grid_phi) - 1)
        q, d1 = np.ascontiguousarray(points.q), np.ascontiguousarray(points.d1)
        parts_by_joints(grid_phi, q, d1, bounds.speed, spacing, parts)
        if not parts.max() > 1.0:
            return grid_phi, points
    grid_phi = _divided(grid_phi, parts)
    return grid_phi, motion.at(grid_phi)


def _divided(grid_phi: Array, parts: Array) -> Array:
    """Return the grid points with the intervals between them in equal parts, (m,) and (m - 1,)."""
    divided = np.empty(int(parts.sum()) + 1)
    divide(grid_phi, parts, divided)
    return divided


@kernel
def parts_by_rate(grid_phi: Array1, phi: Array1, rates: Array1, parts: Array1) -> None:
    """Write into how many parts intervals are divided, so that these last little longer than at full rate.

    Args:
        grid_phi: nominal times [s], rising, shape (m,).
        phi: nominal times at which rates are known [s], rising, shape (k,).
        rates: estimates of dφ/dt there, in ]0, 1]; the lowest on an interval and its neighbours counts, (k,).
        parts: becomes the numbers of parts, shape (m - 1,).
    """
    last = grid_phi.shape[0] - 2
    for i in range(last + 1):
        parts[i] = 1.0
    interval = 0
    for k in range(phi.shape[0]):
        while interval < last and grid_phi[interval + 1] <= phi[k]:
            interval += 1
        for i in range(max(interval - 1, 0), min(interval + 1, last) + 1):
            parts[i] = max(parts[i], math.ceil(1.0 / (rates[k] * _LITTLE_LONGER)))
    for i in range(last + 1):
        parts[i] = min(parts[i], _MOST_PARTS)


@kernel
def parts_by_joints(
    grid_phi: Array1, q: Array2, d1: Array2, speed: Array1, spacing: float, parts: Array1
) -> None:
    """Write the parts of intervals in which joints go far or speed bounds change steeply.

    Args:
        grid_phi: nominal times [s], rising, shape (m,).
        q: coordinates of the joints there, shape (m, n).
        d1: their derivatives by nominal time, shape (m, n).
        speed: limits of the joints, shape (n,).
        spacing: real time between two grid points [s].
        parts: becomes the numbers of parts, shape (m - 1,).
    """
    before = 0.0
    for i in range(grid_phi.shape[0]):
        fast, lasts = 1.0, 0.0
        for j in range(speed.shape[0]):
            fast = max(fast, abs(d1[i, j]) / speed[j])
            if i > 0:
                lasts = max(lasts, abs(q[i, j] - q[i - 1, j]) / speed[j])
        allowed = math.log(1.0 / fast) if fast > 1.0 else 0.0
        if i > 0:
            needed = math.ceil(max(lasts / (_LONG * spacing), abs(allowed - before) / _STEEP))
            is_short = grid_phi[i] - grid_phi[i - 1] < _LEAST_PART * spacing
            parts[i - 1] = 1.0 if is_short else min(max(needed, 1.0), _MOST_PARTS)
        before = allowed


@kernel
def divide(grid_phi: Array1, parts: Array1, out: Array1) -> None:
    """Write grid points with the intervals between them in equal parts.

    Args:
        grid_phi: rising, shape (m,).
        parts: numbers of parts, from 1 on, shape (m - 1,).
        out: becomes the grid points, one more than there are parts.
    """
    row = 0
    for i in range(parts.shape[0]):
        interval = grid_phi[i + 1] - grid_phi[i]
        for number in range(int(parts[i])):
            out[row] = grid_phi[i] + interval * (number / parts[i])
            row += 1
    out[row] = grid_phi[parts.shape[0]]
