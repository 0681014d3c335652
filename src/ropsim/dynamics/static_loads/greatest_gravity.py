"""The greatest efforts that gravity asks of the axes of an arm in any posture within its limits."""

import numpy as np

from ropsim.dynamics.static_loads.gravity_loads import gravity_loads
from ropsim.kinematics import configurations
from ropsim.model import Mechanism, coupled_limits
from ropsim.spatial import Array

POSTURES = 128
"""Postures in which the search begins."""
STARTS = 4
"""Of these the ones from which it goes on, for each axis."""
VALUES = 73
"""Values of a coordinate that are tried, over a turn every 5°: the greatest effort is missed by 0.1 %."""
_SWEEPS = 4
_TURN = 2.0 * np.pi
_BETTER = 1e-6  # relative gain below which the search ends


def greatest_gravity_loads(robot: Mechanism) -> Array:
    """Return the greatest efforts that hold the arm against gravity, without sign [N·m | N], shape (n,).

    Evenly spread postures miss the worst one, which is often at the limits of several axes. So for each axis
    the coordinates of the best of them are led one after another to where the axis bears most (search along
    coordinates). Postures beyond the limits of coupled joints do not count.

    Args:
        robot: n axes, without payload; the masses of its links count.
    """
    lower, upper = _range(robot)
    seeds = np.vstack((configurations(robot, POSTURES), np.clip(np.zeros(robot.n), lower, upper)))
    best = np.argsort(-_loads(robot, seeds), axis=0, kind="stable")[:STARTS].T  # (n, s)
    Q, axes = seeds[best.ravel()], np.repeat(np.arange(robot.n), best.shape[1])
    rows = np.arange(len(Q))
    found = _loads(robot, Q)[rows, axes]
    for _ in range(_SWEEPS):
        before = found
        for axis in range(robot.n):
            tried = np.repeat(Q[:, None], VALUES + 1, axis=1)
            tried[:, 1:, axis] = np.linspace(lower[axis], upper[axis], VALUES)
            loads = _loads(robot, tried.reshape(-1, robot.n)).reshape(len(Q), VALUES + 1, robot.n)
            loads = loads[rows, :, axes]
            chosen = loads.argmax(axis=1)
            Q, found = tried[rows, chosen], loads[rows, chosen]
        if (found <= before * (1.0 + _BETTER)).all():
            break
    return np.asarray(found.reshape(robot.n, -1).max(axis=1))


def _range(robot: Mechanism) -> tuple[Array, Array]:
    """Return the limits of the axes, of one turn at most [rad | m]."""
    wide = robot.upper_limits - robot.lower_limits > _TURN
    lower = np.where(wide, np.maximum(robot.lower_limits, -np.pi), robot.lower_limits)
    return lower, np.minimum(robot.upper_limits, lower + _TURN)


def _loads(robot: Mechanism, Q: Array) -> Array:
    """Return the efforts against gravity, shape (k, n), without sign; beyond coupled limits 0."""
    loads = np.abs(gravity_loads(robot, Q))
    loads[coupled_limits(robot).excess(Q).any(axis=-1)] = 0.0
    return loads
