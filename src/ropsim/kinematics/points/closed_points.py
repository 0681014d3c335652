"""Points of arms with closed chains: the calls of the kernels."""

import numpy as np

from ropsim.kinematics.chain.closed_arrays import ClosedArrays
from ropsim.kinematics.chain.closed_motion import jacobians_of_loops
from ropsim.kinematics.chain.closure import closed_states
from ropsim.kinematics.points.closed_point_kernel import ROOM, closed_point_rows, follow_closed_points
from ropsim.kinematics.points.point_arm import PointShape
from ropsim.kinematics.solutions.polish import unbounded
from ropsim.spatial import Array

NEAREST_STEPS, LONGEST, SHORT = 200, 0.2, 1e-9
"""Steps to the nearest place at most; their longest and shortest way of an axis [rad | m]."""
MOST_DAMPING = 1e6
EFFORT = 40
"""Steps that are made to follow chains from home: more lead past dead centres."""


def closed_rows(
    shape: PointShape, loops: ClosedArrays, goals: Array, starts: Array, *, continued: bool
) -> tuple[Array, Array]:
    """Return coordinates of the axes for points, and what is left.

    Args:
        shape: of the arm.
        loops: the arm.
        goals: points in the base frame of the arm [m], shape (k, 3).
        starts: coordinates of the axes [rad | m], shape (k, n).
        continued: whether each row starts from the one before it, and the first one from its own.

    Returns:
        Coordinates (k, n); errors along the basis and in all [m], and the determinant of the Jacobian along
        the basis, whose sign tells one branch from the next, shape (k, 3).
    """
    q, misses = np.array(starts), np.empty((len(starts), 3))
    near, settings = loops.within(EFFORT), np.array([float(continued)])
    work, room = loops.work(), _room(loops)
    closed_point_rows(
        near.arm(), shape.tcp, shape.space, _poses(goals), q, unbounded(loops.n), settings, room, work, misses
    )
    return q, misses


def closed_followed(
    shape: PointShape,
    loops: ClosedArrays,
    s: Array,
    goals: Array,
    rates: Array,
    q_start: Array,
    slacks: tuple[float, float],
) -> tuple[Array, Array] | None:
    """Return coordinates (k, n) along a path of the TCP, and derivatives (2, k, n); see `followed_points`.

    Args:
        shape: of the arm.
        loops: the arm.
        s: path parameters, shape (k,).
        goals: points in the base frame of the arm [m], shape (k, 3).
        rates: first and second derivatives of the TCP, shape (2, k, 3).
        q_start: coordinates of the axes at the first point [rad | m], shape (n,).
        slacks: largest allowed errors along the basis and in all [m].
    """
    if shape.spare:
        return None
    q, out = np.empty((len(s), loops.n)), np.empty((2, len(s), loops.n))
    q[0], result = q_start, np.array([*slacks, 0.0, 0.0, 0.0])
    place, near = np.vstack((shape.tcp, shape.space)), loops.within(EFFORT)
    work, room = loops.work(), _room(loops)
    follow_closed_points(near.arm(), place, s, _poses(goals), rates, q, out, room, work, result)
    return None if result[0] < 0.0 else (q, out)


def closed_nearest(shape: PointShape, loops: ClosedArrays, goal: Array, q: Array) -> tuple[Array, float]:
    """Return where the TCP comes nearest to a point out of reach, by damped steps that the chains follow.

    Args:
        shape: of the arm.
        loops: the arm.
        goal: in the base frame of the arm [m], shape (3,).
        q: coordinates of the axes at which the chains close [rad | m], shape (n,).

    Returns:
        Coordinates (n,), and the distance that is left [m]: the least one near to the start.
    """
    X_MT, near = np.eye(4), loops.within(EFFORT)
    X_MT[:3, 3] = shape.tcp

    def place(rows: Array) -> tuple[Array, Array]:
        X_BT, J = jacobians_of_loops(near, rows, X_MT)
        return goal - X_BT[0, :3, 3], J[0, :3]

    e, J = place(q[np.newaxis])
    damping = 1e-4
    for _ in range(NEAREST_STEPS):
        step = np.linalg.solve(J.T @ J + damping * np.eye(loops.n), J.T @ e)
        trial = q + step * min(1.0, LONGEST / max(float(np.abs(step).max()), 1e-300))
        closes = closed_states(near, trial[np.newaxis])[1][0, 0] == 1.0
        e_trial, J_trial = place(trial[np.newaxis])
        if closes and np.linalg.norm(e_trial) < np.linalg.norm(e):
            q, e, J, damping = trial, e_trial, J_trial, max(0.2 * damping, 1e-12)
        else:
            damping *= 8.0
        if damping > MOST_DAMPING or float(np.abs(step).max()) < SHORT:
            break
    return q, float(np.linalg.norm(e))


def _room(loops: ClosedArrays) -> Array:
    n = loops.n
    return np.zeros((n + 12 + ROOM, max(len(loops.home), 8, n + 2)))


def _poses(goals: Array) -> Array:
    """Return points (k, 3) in the last columns of matrices, shape (k, 4, 4)."""
    T = np.zeros((len(goals), 4, 4))
    T[:] = np.eye(4)
    T[:, :3, 3] = goals
    return T
