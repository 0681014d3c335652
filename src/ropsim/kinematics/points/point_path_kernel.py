"""Joints along a path of the TCP whatever the orientation, with derivatives, in loops that numba compiles.

From row to row they are integrated by the two-derivative formula of fourth order as in `followed_kernel`.
"""

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.kinematics.chain.path_derivatives_kernel import DerivativeWork, column_changes
from ropsim.kinematics.points.point_kernel import (
    A1,
    CHANGES,
    ERROR,
    HELD,
    LAMBDA,
    SCALE,
    SHARES,
    SLOPE,
    VALUES,
    A,
    PointArm,
    descend_to,
    least_shares,
    limited_scales,
    normal_matrix,
    place,
    plain_scales,
)
from ropsim.spatial import Array

SINGULAR = 1e-8
"""Least eigenvalue that counts by the greatest one; below, rounding would count in derivatives."""
CLOSE = 0.1
"""A row this far from its prediction [rad | m] may be on another branch."""


@kernel
def follow_points(
    arm: PointArm,
    s: Array1,
    goals: Array2,
    tool: Array3,
    Q: Array2,
    out: Array3,
    work: DerivativeWork,
    room: Array2,
    result: Array1,
) -> None:
    """Write joint coordinates and their derivatives along a path of the TCP.

    From row to row they are integrated by the two-derivative formula of fourth order as in `follow_rows`, and
    brought to their points.

    Args:
        arm: the arm.
        s: path parameters, rising, shape (k,).
        goals: the TCP there in the base frame [m], shape (k, 3).
        tool: first and second derivatives of the TCP, shape (2, k, 3).
        Q: coordinates at the first row [rad | m]; afterwards at all, shape (k, n).
        out: where their derivatives go, shape (2, k, n).
        work: room to work in.
        room: as in `reach_rows`.
        result: largest allowed errors along the basis and in all [m]; the first one is set to -1.0 where a
            row is not reached, singular or maybe on another branch, shape (2,).
    """
    n, side = Q.shape[1], 0.0
    for i in range(n):
        room[HELD, i] = 0.0
    for k in range(Q.shape[0]):
        h = s[k] - s[k - 1] if k > 0 else 0.0
        for pass_ in range(2 if k > 0 else 1):
            for i in range(n):
                if k > 0 and pass_ == 0:
                    Q[k, i] = Q[k - 1, i] + h * (out[0, k - 1, i] + 0.5 * h * out[1, k - 1, i])
                elif k > 0:
                    mean = 0.5 * (out[0, k - 1, i] + out[0, k, i])
                    Q[k, i] = Q[k - 1, i] + h * (mean + h / 12.0 * (out[1, k - 1, i] - out[1, k, i]))
                room[CHANGES, i] = Q[k, i]
            limited_scales(arm, Q[k], room)
            descend_to(arm, goals[k], Q[k], work, room, room[LAMBDA])
            away = 0.0
            for i in range(n):
                away = max(away, abs(Q[k, i] - room[CHANGES, i]))
            reached = room[LAMBDA, 0] <= result[0] and room[LAMBDA, 1] <= result[1]
            if (
                not reached
                or away > CLOSE
                or not derive(arm, Q[k], tool[0, k], tool[1, k], out[0, k], out[1, k], work, room)
            ):
                result[0] = -1.0
                return
        here = branch_side(arm, room)
        if side * here < 0.0:
            result[0] = -1.0
            return
        side = here if here != 0.0 else side


@kernel
def branch_sides(arm: PointArm, Q: Array2, work: DerivativeWork, room: Array2, sides: Array1) -> None:
    """Write the determinant of A at rows of Q (k, n), 0 where the arm has more joints than it needs; (k,)."""
    plain_scales(arm, room)
    for k in range(Q.shape[0]):
        place(arm, Q[k], work)
        normal_matrix(arm, work, room)
        sides[k] = branch_side(arm, room)


def derive(
    arm: PointArm,
    q: Array,
    d1: Array,
    d2: Array,
    first: Array,
    second: Array,
    work: DerivativeWork,
    room: Array,
) -> bool:
    """Write both derivatives of the joints where the frames are placed; return whether there are.

    With x = Aᵀ·λ and A·x = S·v' follow x' = A'ᵀ·λ + Aᵀ·λ' and A·Aᵀ·λ' = S·a' - A'·x - A·A'ᵀ·λ.
    """
    d, n = arm.space.shape[0], first.shape[0]
    limited_scales(arm, q, room)
    normal_matrix(arm, work, room)
    rank = int(arm.rank[0])
    if not room[VALUES, rank - 1] > SINGULAR * room[VALUES, 0]:
        return False
    for a in range(d):
        room[ERROR, a] = arm.space[a, 0] * d1[0] + arm.space[a, 1] * d1[1] + arm.space[a, 2] * d1[2]
    least_shares(arm, room, 0.0, room[SHARES])
    for i in range(n):
        first[i] = room[SHARES, i] * room[SCALE, i]
        room[SLOPE, i] *= first[i]  # the derivative of the scale along the path from here on
    column_changes(arm.chain, arm.spread, work, first)
    for a in range(d):
        for i in range(n):
            total = 0.0
            for r in range(3):
                change = work.columns[6 + r, i] * room[SCALE, i] + work.columns[r, i] * room[SLOPE, i]
                total += arm.space[a, r] * change
            room[A1 + a, i] = total
    for i in range(n):
        total = 0.0
        for a in range(d):
            total += room[A1 + a, i] * room[LAMBDA, a]
        room[CHANGES, i] = total
        second[i] = room[SLOPE, i] * room[SHARES, i]
    for a in range(d):
        total = arm.space[a, 0] * d2[0] + arm.space[a, 1] * d2[1] + arm.space[a, 2] * d2[2]
        for i in range(n):
            total -= room[A1 + a, i] * room[SHARES, i] + room[A + a, i] * room[CHANGES, i]
        room[ERROR, a] = total
    least_shares(arm, room, 0.0, room[SHARES])
    for i in range(n):
        second[i] += (room[CHANGES, i] + room[SHARES, i]) * room[SCALE, i]
    return True


def branch_side(arm: PointArm, room: Array) -> float:
    """Return the determinant of A, 0.0 where it is not square: its sign tells one branch from the next."""
    d, n = arm.space.shape[0], arm.scale.shape[0]
    if n != d:
        return 0.0
    if d == 1:
        return float(room[A, 0])
    if d == 2:
        return float(room[A, 0] * room[A + 1, 1] - room[A, 1] * room[A + 1, 0])
    return float(
        room[A, 0] * (room[A + 1, 1] * room[A + 2, 2] - room[A + 1, 2] * room[A + 2, 1])
        - room[A, 1] * (room[A + 1, 0] * room[A + 2, 2] - room[A + 1, 2] * room[A + 2, 0])
        + room[A, 2] * (room[A + 1, 0] * room[A + 2, 1] - room[A + 1, 1] * room[A + 2, 0])
    )
