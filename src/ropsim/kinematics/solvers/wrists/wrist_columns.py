"""The closed form of arms with spherical wrist for eight branches at a time, a column for each.

The symbols are defined in `spherical_wrist.py`. Angles are carried as (cosine, sine) pairs; only the answer
takes an inverse tangent. Wrist: with N = R_F·Ry(θ23)·Rz(-θ1)·R_Jᵀ·R_BM·R_M the angles of axes 4 to 6 solve N
= Rz(A)·Ry(β)·Rz(C). A comes from the third column, then C from the second row of Rz(-A)·N, which stays exact
where β goes to 0 or π and A alone loses its meaning (Euler angles as in Paul 1981).

Each branch is checked by forward kinematics of the angles found; of one that misses the pose there is none.
For an arm that was snapped into the class the slacks are as wide as the snap: its branches are starts for
`polish.py`.
"""

from math import atan2, nan, pi, sqrt

import numpy as np

from ropsim.codegen import columns
from ropsim.spatial import Array

LENGTHS, SIGNS, ZEROS, FRONT, X_J, X_M, R_F, SLACKS = 0, 5, 11, 17, 18, 30, 42, 51
"""Where the fields of `WristArm.flat` begin; frames lie by rows."""

COLUMNS = 8
"""Number of branches computed at a time."""
POSE, SIDES, PLACE, PAIRS, N, ANGLES, MISS, FOUND, SHEET = 0, 12, 14, 26, 30, 39, 48, 49, 58
"""Rows of the columns: R_BM and p_BM by rows; the signs that `reach_in_columns` takes; the same pose with M
turned by the constants, in frame J, the wrist centre last; cosine and sine of θ1 and θ23; N; the angles of
axes 1 to 6, FLIP, then the angles of axes 4 to 6, NOFLIP; how far the branch is off the pose, no number where
it is not within reach; the nine joint coordinates.
"""
_TURN, _PER_TURN = 2.0 * pi, 0.5 / pi


@columns
def place_in_columns(
    count: int,
    arm: Array,
    a: float,
    b: float,
    c: float,
    centre: float,
    X: Array,
    x: Array,
    y: Array,
    z: Array,
) -> None:
    """Write in J the direction (a, b, c) of M, or where that point is if it is the centre (1, else 0)."""
    for j in range(count):
        u = X[0, j] * a + X[1, j] * b + X[2, j] * c + (X[9, j] - arm[X_J + 3]) * centre
        v = X[3, j] * a + X[4, j] * b + X[5, j] * c + (X[10, j] - arm[X_J + 7]) * centre
        w = X[6, j] * a + X[7, j] * b + X[8, j] * c + (X[11, j] - arm[X_J + 11]) * centre
        x[j] = arm[X_J] * u + arm[X_J + 4] * v + arm[X_J + 8] * w
        y[j] = arm[X_J + 1] * u + arm[X_J + 5] * v + arm[X_J + 9] * w
        z[j] = arm[X_J + 2] * u + arm[X_J + 6] * v + arm[X_J + 10] * w


@columns
def reach_in_columns(count: int, arm: Array, c_free: float, s_free: float, room: Array) -> None:
    """Write the angles of axes 1 to 3 that bring the wrist centre to its place.

    Args:
        count: of the columns.
        arm: `WristArm.flat`.
        c_free: cosine of θ1 for a wrist centre on axis 1.
        s_free: sine of it.
        room: rows as above; the two signs belong to the centre's distance along e_x and of sin θ3.
    """
    for j in range(count):
        px = room[PLACE + 9, j]
        py = room[PLACE + 10, j]
        wz = room[PLACE + 11, j] - arm[LENGTHS + 1]
        aside = arm[LENGTHS + 2]
        upper = arm[LENGTHS + 3]
        fore = arm[LENGTHS + 4]
        reach = px * px + py * py
        left = reach - aside * aside
        x = room[SIDES, j] * sqrt(max(0.0, left))
        wx = x - arm[LENGTHS]
        c_elbow = (wx * wx + wz * wz - upper * upper - fore * fore) / (2.0 * upper * fore)
        bent = min(1.0 - arm[SLACKS + 4], max(arm[SLACKS + 4] - 1.0, c_elbow))
        s_elbow = room[SIDES + 1, j] * sqrt((1.0 - bent) * (1.0 + bent))
        to_x = px * x - py * aside
        to_y = py * x + px * aside
        far = sqrt(to_x * to_x + to_y * to_y) if reach >= arm[SLACKS + 1] * arm[SLACKS + 1] else 0.0
        scale = 1.0 / far if far > 0.0 else 0.0
        c1 = to_x * scale if far > 0.0 else c_free
        s1 = to_y * scale if far > 0.0 else s_free
        along = upper + fore * bent
        over = fore * s_elbow
        to_x = wx * along + wz * over
        to_y = wz * along - wx * over
        far = sqrt(to_x * to_x + to_y * to_y)
        scale = 1.0 / far if far > 0.0 else 0.0
        c2 = to_x * scale if far > 0.0 else 1.0
        s2 = to_y * scale
        c23 = c2 * bent - s2 * s_elbow
        s23 = s2 * bent + c2 * s_elbow
        miss = abs(c1 * x + s1 * aside - px) + abs(s1 * x - c1 * aside - py)
        miss = miss + abs(upper * c2 + fore * c23 - wx) + abs(upper * s2 + fore * s23 - wz)
        miss = miss if left >= -arm[SLACKS + 3] else nan
        room[MISS, j] = miss if abs(c_elbow) <= 1.0 + arm[SLACKS + 3] else nan
        room[PAIRS, j] = c1
        room[PAIRS + 1, j] = s1
        room[PAIRS + 2, j] = c23
        room[PAIRS + 3, j] = s23
        room[ANGLES, j] = atan2(s1, c1)
        room[ANGLES + 1, j] = atan2(s2, c2)
        room[ANGLES + 2, j] = atan2(s_elbow, bent)


@columns
def turn_in_columns(
    count: int, arm: Array, pairs: Array, x: Array, y: Array, z: Array, one: Array, other: Array, last: Array
) -> None:
    """Write a column of N, R_F·Ry(θ23)·Rz(-θ1)·(x, y, z)."""
    for j in range(count):
        level = pairs[0, j] * x[j] + pairs[1, j] * y[j]
        across = pairs[0, j] * y[j] - pairs[1, j] * x[j]
        along = pairs[2, j] * level + pairs[3, j] * z[j]
        over = pairs[2, j] * z[j] - pairs[3, j] * level
        one[j] = arm[R_F] * along + arm[R_F + 1] * across + arm[R_F + 2] * over
        other[j] = arm[R_F + 3] * along + arm[R_F + 4] * across + arm[R_F + 5] * over
        last[j] = arm[R_F + 6] * along + arm[R_F + 7] * across + arm[R_F + 8] * over


@columns
def wrist_in_columns(count: int, arm: Array, c_free: float, s_free: float, room: Array) -> None:
    """Write A, β >= 0, C with N = Rz(A)·Ry(β)·Rz(C), and the one with β <= 0; add the sum of entry errors.

    Args:
        count: of the columns.
        arm: `WristArm.flat`.
        c_free: cosine of A where axes 4 and 6 are aligned.
        s_free: sine of it.
        room: rows as above.
    """
    for j in range(count):
        n2 = room[N + 2, j]
        n5 = room[N + 5, j]
        n8 = room[N + 8, j]
        sb = sqrt(n2 * n2 + n5 * n5)
        aligned = 1.0 if sb < arm[SLACKS + 2] else 0.0
        scale = 1.0 / sb if sb > 0.0 else 0.0
        c4 = c_free if aligned > 0.0 else n2 * scale
        s4 = s_free if aligned > 0.0 else n5 * scale
        sb = 0.0 if aligned > 0.0 else sb
        whole = 1.0 if n8 > 0.0 else -1.0
        cb = whole if aligned > 0.0 else n8
        scale = 1.0 / sqrt(cb * cb + sb * sb)
        cb = cb * scale
        sb = sb * scale
        c6 = c4 * room[N + 4, j] - s4 * room[N + 1, j]
        s6 = c4 * room[N + 3, j] - s4 * room[N, j]
        far = sqrt(c6 * c6 + s6 * s6)
        scale = 1.0 / far if far > 0.0 else 0.0
        c6 = c6 * scale if far > 0.0 else 1.0
        s6 = s6 * scale
        miss = room[MISS, j] + abs(c4 * cb * c6 - s4 * s6 - room[N, j])
        miss = miss + abs(-c4 * cb * s6 - s4 * c6 - room[N + 1, j]) + abs(c4 * sb - n2)
        miss = miss + abs(s4 * cb * c6 + c4 * s6 - room[N + 3, j])
        miss = miss + abs(-s4 * cb * s6 + c4 * c6 - room[N + 4, j]) + abs(s4 * sb - n5)
        room[MISS, j] = miss + abs(-sb * c6 - room[N + 6, j]) + abs(sb * s6 - room[N + 7, j]) + abs(cb - n8)
        a = atan2(s4, c4)
        b = atan2(sb, cb)
        c = atan2(s6, c6)
        room[ANGLES + 3, j] = a
        room[ANGLES + 4, j] = b
        room[ANGLES + 5, j] = c
        room[ANGLES + 6, j] = a if aligned > 0.0 else a + pi
        room[ANGLES + 7, j] = b if aligned > 0.0 else -b
        room[ANGLES + 8, j] = c if aligned > 0.0 else c + pi


@columns
def coordinate_in_columns(
    count: int, sign: float, zero: float, accepted: float, angle: Array, miss: Array, q: Array
) -> None:
    """Write sign·(angle - zero) in (-π, π] of branches that are no farther off than is accepted."""
    for j in range(count):
        turned = sign * (angle[j] - zero)
        whole = turned - _TURN * np.rint(turned * _PER_TURN)
        near = whole if abs(whole) < pi else pi  # rounding may leave ±π a bit outside
        q[j] = near if miss[j] <= accepted else nan
