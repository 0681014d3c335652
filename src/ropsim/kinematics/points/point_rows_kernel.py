"""Rows of joint coordinates brought to points, in plain loops that numba compiles."""

from math import sqrt

from ropsim.codegen import Array1, Array2, kernel
from ropsim.kinematics.chain.path_derivatives_kernel import DerivativeWork
from ropsim.kinematics.points.point_kernel import (
    CHANGES,
    HELD,
    LONGEST_STEP,
    SCALE,
    SHARES,
    TRIAL,
    VALUES,
    VECTORS,
    A,
    PointArm,
    descend_to,
    least_shares,
    limited_scales,
    normal_matrix,
    place,
    plain_scales,
    point_error,
)
from ropsim.spatial import Array


@kernel
def reach_rows(
    arm: PointArm, goals: Array2, Q: Array2, work: DerivativeWork, room: Array2, misses: Array2
) -> None:
    """Bring each row of Q (k, n) to its goal in the base frame [m], (k, 3), or as near as it comes.

    Args:
        arm: the arm.
        goals: one for each row.
        Q: starts, then the answers [rad | m].
        work: room to work in.
        room: room to work in, shape (ROOM, max(n, 3)).
        misses: what is left along the basis of the arm, and in all [m], shape (k, 2).
    """
    plain_scales(arm, room)
    for i in range(Q.shape[1]):
        room[HELD, i] = 0.0
    for k in range(Q.shape[0]):
        descend_to(arm, goals[k], Q[k], work, room, misses[k])


@kernel
def continue_rows(
    arm: PointArm, goals: Array2, Q: Array2, work: DerivativeWork, room: Array2, misses: Array2
) -> None:
    """Bring all rows of Q (k, n) to their goals, each from the one before it; the first one is a start.

    Arguments as in `reach_rows`.
    """
    for i in range(Q.shape[1]):
        room[HELD, i] = 0.0
    for k in range(Q.shape[0]):
        for i in range(Q.shape[1]):
            if k > 0:
                Q[k, i] = Q[k - 1, i]
        limited_scales(arm, Q[k], room)
        descend_to(arm, goals[k], Q[k], work, room, misses[k])


@kernel
def approach_rows(
    arm: PointArm,
    goal: Array1,
    near: Array1,
    bounds: Array2,
    Q: Array2,
    work: DerivativeWork,
    room: Array2,
    rounds: int,
    misses: Array2,
) -> None:
    """Bring each row of Q (k, n), which reaches the goal, as near to `near` as it comes within bounds.

    Along what the point leaves free the shares of the distance are lessened step by step.

    Args:
        arm: the arm.
        goal: for all rows [m], shape (3,).
        near: coordinates [rad | m], shape (n,).
        bounds: of the coordinates, shape (2, n).
        Q: starts, then the answers [rad | m].
        work: room to work in.
        room: as in `reach_rows`.
        rounds: steps at most.
        misses: as in `reach_rows`.
    """
    n = Q.shape[1]
    plain_scales(arm, room)
    for k in range(Q.shape[0]):
        q, step, before = Q[k], 1.0, 1e300
        for i in range(n):
            q[i] = min(max(q[i], bounds[0, i]), bounds[1, i])
            room[HELD, i] = 0.0
        for _ in range(rounds):
            place(arm, q, work)
            point_error(arm, goal, work, room)
            for i in range(n):
                room[HELD, i] = 0.0
            size = _way(arm, q, near, step, room, work)
            for i in range(n):  # those at a bound that would go beyond it stay
                way = room[TRIAL, i]
                at = (way < 0.0 and q[i] <= bounds[0, i]) or (way > 0.0 and q[i] >= bounds[1, i])
                room[HELD, i] = 1.0 if at else 0.0
            size = _way(arm, q, near, step, room, work)
            step *= 0.5 if size > before else 1.0
            before = size
            longest = 0.0
            for i in range(n):
                longest = max(longest, abs(room[TRIAL, i]))
            limit = LONGEST_STEP / longest if longest > LONGEST_STEP else 1.0
            for i in range(n):
                q[i] = min(max(q[i] + limit * room[TRIAL, i], bounds[0, i]), bounds[1, i])
            if longest < 1e-9:
                break
        for i in range(n):  # bounds hold those that are at them
            room[HELD, i] = 1.0 if q[i] <= bounds[0, i] or q[i] >= bounds[1, i] else 0.0
        descend_to(arm, goal, q, work, room, misses[k])


def _way(arm: PointArm, q: Array, near: Array, step: float, room: Array, work: DerivativeWork) -> float:
    """Write the step to the goal and, within what that leaves free, to `near` (n,) [rad | m].

    Returns:
        the length of the way to `near`, in shares.
    """
    normal_matrix(arm, work, room)
    size = _free_way(arm, q, near, room)
    least_shares(arm, room, 0.0, room[TRIAL])
    for i in range(q.shape[0]):
        room[TRIAL, i] = (room[TRIAL, i] + step * room[SHARES, i]) * room[SCALE, i]
    return size


def _free_way(arm: PointArm, q: Array, near: Array, room: Array) -> float:
    """Write the shares of the way to `near` that leave the TCP where it is; return their length."""
    d, n, rank, total = arm.space.shape[0], arm.scale.shape[0], int(arm.rank[0]), 0.0
    for i in range(n):
        held = room[HELD, i] > 0.0
        room[SHARES, i] = 0.0 if held else (near[i] - q[i]) / room[SCALE, i]
    for c in range(rank):
        part = 0.0
        for a in range(d):
            for i in range(n):
                part += room[VECTORS + a, c] * room[A + a, i] * room[SHARES, i]
        room[CHANGES, c] = part / room[VALUES, c] if room[VALUES, c] > 1e-300 else 0.0
    for c in range(rank):
        for a in range(d):
            for i in range(n):
                room[SHARES, i] -= room[CHANGES, c] * room[VECTORS + a, c] * room[A + a, i]
    for i in range(n):
        total += room[SHARES, i] * room[SHARES, i]
    return sqrt(total)
