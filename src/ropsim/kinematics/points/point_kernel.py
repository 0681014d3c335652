"""The TCP of an arm brought to points, whatever the orientation, in plain loops that numba compiles.

With the upper rows J of the Jacobian at the TCP, a basis S (d, 3) of the directions in which the arm moves it
at all and scales c of the joints, A = S·J·diag(c) leads shares x of the joint rates to S·v. Of A·Aᵀ the r
greatest eigenvalues w with their vectors u count, r being what the arm can choose of a position:
x = Aᵀ·Σ u·(uᵀ·S·v)/w are the least shares (Whitney 1969), and near a singularity w + μ stands for w
(Levenberg 1944).
"""

from math import sqrt
from typing import NamedTuple

from ropsim.codegen import Array1, Array2
from ropsim.kinematics.chain.path_derivatives_kernel import DerivativeWork
from ropsim.kinematics.chain.steps_kernel import axis_columns, place_steps, spread_over
from ropsim.kinematics.points.symmetric_kernel import eigenvectors
from ropsim.spatial import Array

GOAL = 1e-15
"""No more steps below this error [m]: it is the rounding of forward kinematics."""
LONGEST_STEP = 0.7
"""No joint moves farther in one step [rad | m]; beyond, the Jacobian says little."""
STEPS = 100
"""Largest number of steps from a start to a point."""
PROGRESS = 1.0 - 1e-7
"""Share of the error that is left after a step with progress at most."""
LEAST = 0.02
"""Share of its scale that a joint keeps at its limit."""
STALLS = 6
"""Number of consecutive steps without progress that ends the search."""
ERROR, LAMBDA, TRIAL, SHARES, CHANGES, HELD, SCALE, SLOPE = range(8)
"""Rows of the room: error along the basis, λ, coordinates tried, shares and their changes, 1.0 for joints
that are held, scales in force, their derivatives by the coordinates."""
VALUES, SQUARE, VECTORS, A, A1 = 8, 9, 12, 15, 18
"""Rows behind them: eigenvalues; three each of A·Aᵀ, its eigenvectors, A and its derivative."""
ROOM = 21
"""Number of these rows."""


class PointArm(NamedTuple):
    """An arm with m steps and n axes and its TCP.

    Attributes:
        chain: `ChainArrays.flat`.
        spread: `ChainArrays.spread`.
        tcp: in the interface [m], shape (3,).
        space: basis of the directions in which the TCP moves, shape (d, 3).
        scale: of the joints away from their limits, shape (n,).
        rank: r, shape (1,).
        limits: lower and upper limits, shape (2, n).
        margins: within which a joint with others to spare gives way to them; 0 for none, shape (n,).
    """

    chain: Array1
    spread: Array2
    tcp: Array1
    space: Array2
    scale: Array1
    rank: Array1
    limits: Array2
    margins: Array1


def descend_to(arm: PointArm, goal: Array, q: Array, work: DerivativeWork, room: Array, miss: Array) -> None:
    """Bring q (n,) to a goal in place, and write what is left along the basis and in all [m] to `miss`.

    Joints that are held in `room` stay.
    """
    n, trial = q.shape[0], room[TRIAL]
    place(arm, q, work)
    error = point_error(arm, goal, work, room)
    mu, stalls = 1e-3, 0
    for _ in range(STEPS):
        if error <= GOAL or stalls > STALLS:
            break
        normal_matrix(arm, work, room)
        helped, tried = False, error
        for _ in range(12):
            least_shares(arm, room, mu * error, room[SHARES])
            longest = 0.0
            for i in range(n):
                longest = max(longest, abs(room[SHARES, i] * room[SCALE, i]))
            limit = LONGEST_STEP / longest if longest > LONGEST_STEP else 1.0
            for i in range(n):
                trial[i] = q[i] + limit * room[SHARES, i] * room[SCALE, i]
            place(arm, trial, work)
            tried = _distance(arm, goal, work)
            if tried < error:
                helped = True
                break
            mu = 1e-6 if mu < 1e-6 else mu * 8.0
        if not helped:
            break
        stalls = stalls + 1 if tried > PROGRESS * error else 0
        mu *= 0.1
        for i in range(n):
            q[i] = trial[i]
        error = point_error(arm, goal, work, room)
    place(arm, q, work)
    miss[0] = point_error(arm, goal, work, room)
    M, total = work.frames[work.frames.shape[0] - 1], 0.0
    for r in range(3):
        total += (goal[r] - M[9 + r]) ** 2
    miss[1] = sqrt(total)


def plain_scales(arm: PointArm, room: Array) -> None:
    """Put the scales away from limits in force."""
    for i in range(arm.scale.shape[0]):
        room[SCALE, i], room[SLOPE, i] = arm.scale[i], 0.0


def limited_scales(arm: PointArm, q: Array, room: Array) -> None:
    """Put the scales at coordinates q (n,) in force: within its margin a joint does less, by a smooth step.

    Joints that others can replace stay off their limits so (Chan and Dubey 1995).
    """
    for i in range(q.shape[0]):
        room[SCALE, i], room[SLOPE, i] = arm.scale[i], 0.0
        below, above = q[i] - arm.limits[0, i], arm.limits[1, i] - q[i]
        u = max(min(below, above), 0.0) / arm.margins[i] if arm.margins[i] > 0.0 else 1.0
        if u < 1.0:
            step, rise = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u), 30.0 * u * u * (1.0 - u) * (1.0 - u)
            room[SCALE, i] = arm.scale[i] * (LEAST + (1.0 - LEAST) * step)
            slope = arm.scale[i] * (1.0 - LEAST) * rise / arm.margins[i]
            room[SLOPE, i] = slope if below < above else -slope


def place(arm: PointArm, q: Array, work: DerivativeWork) -> None:
    """Place the frames of the steps, and that of the interface at the TCP, with its Jacobian."""
    spread_over(arm.spread, q, work.lanes[6])
    place_steps(arm.chain, work.lanes[6], work.frames)
    M = work.frames[work.frames.shape[0] - 1]
    for r in range(3):
        M[9 + r] += M[3 * r] * arm.tcp[0] + M[3 * r + 1] * arm.tcp[1] + M[3 * r + 2] * arm.tcp[2]


def point_error(arm: PointArm, goal: Array, work: DerivativeWork, room: Array) -> float:
    """Write the error along the basis; return its length [m]."""
    M, total = work.frames[work.frames.shape[0] - 1], 0.0
    for a in range(arm.space.shape[0]):
        part = 0.0
        for r in range(3):
            part += arm.space[a, r] * (goal[r] - M[9 + r])
        room[ERROR, a] = part
        total += part * part
    return sqrt(total)


def _distance(arm: PointArm, goal: Array, work: DerivativeWork) -> float:
    """Return the length of the error along the basis [m]."""
    M, total = work.frames[work.frames.shape[0] - 1], 0.0
    for a in range(arm.space.shape[0]):
        part = 0.0
        for r in range(3):
            part += arm.space[a, r] * (goal[r] - M[9 + r])
        total += part * part
    return sqrt(total)


def normal_matrix(arm: PointArm, work: DerivativeWork, room: Array) -> None:
    """Write A where the frames are placed, without joints that are held, and the eigenvectors of A·Aᵀ."""
    d, n = arm.space.shape[0], arm.scale.shape[0]
    axis_columns(arm.chain, arm.spread, work.frames, work.columns, work.lanes)
    for a in range(d):
        for i in range(n):
            total = 0.0
            for r in range(3):
                total += arm.space[a, r] * work.columns[r, i]
            room[A + a, i] = total * room[SCALE, i] * (1.0 - room[HELD, i])
    for a in range(d):
        for b in range(d):
            total = 0.0
            for i in range(n):
                total += room[A + a, i] * room[A + b, i]
            room[SQUARE + a, b] = total
    eigenvectors(d, room[SQUARE : SQUARE + 3], room[VECTORS : VECTORS + 3], room[VALUES])


def least_shares(arm: PointArm, room: Array, damping: float, out: Array) -> None:
    """Write the least shares (n,) that make up for the error along the basis; λ is in `room` then."""
    d, n, rank = arm.space.shape[0], arm.scale.shape[0], int(arm.rank[0])
    for a in range(d):
        room[LAMBDA, a] = 0.0
    for c in range(rank):
        part = 0.0
        for a in range(d):
            part += room[VECTORS + a, c] * room[ERROR, a]
        value = room[VALUES, c] + damping
        part = part / value if value > 1e-300 else 0.0
        for a in range(d):
            room[LAMBDA, a] += part * room[VECTORS + a, c]
    for i in range(n):
        total = 0.0
        for a in range(d):
            total += room[A + a, i] * room[LAMBDA, a]
        out[i] = total
