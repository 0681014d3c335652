"""Closed-form inverse kinematics of arms with spherical wrist, in plain loops that numba compiles.

The symbols are those of `spherical_wrist.py`. Angles are carried as (cosine, sine) pairs; only the answer
takes an inverse tangent. Wrist: with N = R_F·Ry(θ23)·Rz(-θ1)·R_Jᵀ·R_BM·R_M the angles of axes 4 to 6 solve
N = Rz(A)·Ry(β)·Rz(C). A comes from the third column, then C from the second row of Rz(-A)·N, which stays
exact where β goes to 0 or π and A alone loses its meaning (Euler angles as in Paul 1981).

Each row is checked by forward kinematics of the angles found; rows that miss the pose stay NaN. For an arm
that was snapped into the class the slacks are as wide as the snap: its rows are starts for `polish.py`.
"""

from math import atan2, ceil, cos, nan, pi, sin, sqrt

from ropsim.codegen import kernel
from ropsim.spatial import Array

WRIST_SLACK = 1e-10
"""With sin β below this, axes 4 and 6 count as aligned; the error made stays below the promised accuracy."""
REACH_SLACK = 1e-10
"""A cosine or a squared length [m²] this far beyond its bound is rounding at the edge of reach."""
AXIS_SLACK = 1e-10
"""A wrist centre this near to axis 1 [m] lies on it."""

LENGTHS, SIGNS, ZEROS, FRONT, X_J, X_M, R_F, SLACKS = 0, 5, 11, 17, 18, 30, 42, 51
"""Where the fields of `WristArm.flat` begin; frames lie by rows."""

TIE = 1e-9
"""A singular configuration belongs to two branches; within this [m, rad] it is given the first one."""

ALL_ROWS = -1
"""Stands for every row."""

ROOM_OF_ROWS = 30
"""So many numbers are room to work in, the first six joint coordinates that a singular pose keeps."""


@kernel("void(f8[::1], f8[::1], f8[:,:,::1], f8[:,:,::1])")
def inverse_rows(arm: Array, room: Array, T: Array, out: Array) -> None:
    """Write all branches of every pose X_BM in T (k, 4, 4) to out (k, 8, 6), NaN where absent.

    Args:
        arm: `WristArm.flat`.
        room: joint coordinates [rad] of which q1 and q4 hold where the pose leaves them free (6 numbers), and
            room to work in; shape (ROOM_OF_ROWS,).
        T: poses.
        out: row 4·shoulder + 2·elbow + wrist holds that posture, angles in (-π, π].
    """
    for k in range(T.shape[0]):
        _write_rows(arm, room, T[k], ALL_ROWS, out[k])


@kernel("void(f8[::1], f8[::1], f8[:,::1], i8, f8[:,::1])")
def inverse_row(arm: Array, room: Array, X: Array, row: int, out: Array) -> None:
    """Write some branches of one pose, as `inverse_rows` does all of many.

    Args:
        arm: `WristArm.flat`.
        room: as there.
        X: the pose X_BM, shape (4, 4).
        row: of a branch: it and that with the wrist turned over are written; ALL_ROWS for every one.
        out: where they go, NaN where absent, others stay, shape (8, 6).
    """
    _write_rows(arm, room, X, row, out)


@kernel("void(f8[::1], f8[::1], f8, f8[::1])")
def wrist_posture(arm: Array, q: Array, side: float, told: Array) -> None:
    """Write to which branch joint coordinates belong, and how near they are to a singular place.

    Args:
        arm: `WristArm.flat`.
        q: joint coordinates [rad], shape (6,).
        side: added to all of them [rad].
        told: becomes the row of the branch, and the least of the distance of the wrist centre from axis 1
            along e_x [m] and the sines of elbow and wrist, without their signs; shape (2,).
    """
    shoulder = (q[1] + side) * arm[SIGNS + 1] + arm[ZEROS + 1]
    elbow = (q[2] + side) * arm[SIGNS + 2] + arm[ZEROS + 2]
    wrist = (q[4] + side) * arm[SIGNS + 4] + arm[ZEROS + 4]
    front = arm[FRONT]
    ahead = arm[LENGTHS] + arm[LENGTHS + 3] * cos(shoulder) + arm[LENGTHS + 4] * cos(shoulder + elbow)
    bend, flip = sin(elbow), sin(wrist)
    above = -bend if ahead * front > TIE else bend
    row = 4 if ahead * front > TIE else 0
    row += 0 if above * front >= -TIE else 2
    told[0], told[1] = row + (1 if flip > TIE else 0), min(abs(ahead), abs(bend), abs(flip))


def _write_rows(arm: Array, room: Array, X: Array, only: int, out: Array) -> None:
    a1, h, D, upper, fore = arm[0], arm[1], arm[2], arm[3], arm[4]
    front = arm[FRONT]
    free1, free4 = arm[SIGNS] * room[0] + arm[ZEROS], arm[SIGNS + 3] * room[3] + arm[ZEROS + 3]
    accepted, on_axis, aligned_below = arm[SLACKS], arm[SLACKS + 1], arm[SLACKS + 2]
    beyond, least_bend = arm[SLACKS + 3], arm[SLACKS + 4]
    G, N, angles = room[6:15], room[15:24], room[24:30]
    for row in range(8):
        if only == ALL_ROWS or row // 2 == only // 2:
            for j in range(6):
                out[row, j] = nan
    # Wrist centre and M, turned by the constants, in frame J.
    for c in range(3):
        G[c], G[3 + c], G[6 + c] = _in_arm(arm, X, c, 0.0)
    px, py, pz = _in_arm(arm, X, 3, 1.0)
    wz = pz - h
    reach = px * px + py * py
    ahead = reach - D * D
    if not ahead >= -beyond:
        return
    ahead = sqrt(max(ahead, 0.0))
    for shoulder in range(2):
        if only != ALL_ROWS and only // 4 != shoulder:
            continue
        x = front * ahead if shoulder == 1 else -front * ahead
        wx = x - a1
        span = wx * wx + wz * wz
        c_elbow = (span - upper * upper - fore * fore) / (2.0 * upper * fore)
        if not abs(c_elbow) <= 1.0 + beyond:
            continue
        c_elbow = min(1.0 - least_bend, max(least_bend - 1.0, c_elbow))
        s_bend = sqrt((1.0 - c_elbow) * (1.0 + c_elbow))
        if reach < on_axis * on_axis:
            c1, s1 = cos(free1), sin(free1)
        else:
            c1, s1 = _direction(px * x - py * D, py * x + px * D, free1)
        miss = abs(c1 * x + s1 * D - px) + abs(s1 * x - c1 * D - py)
        angles[0] = atan2(s1, c1)
        for elbow in range(2):
            if only != ALL_ROWS and only // 2 % 2 != elbow:
                continue
            s_elbow = front * s_bend if elbow == shoulder else -front * s_bend
            along, over = upper + fore * c_elbow, fore * s_elbow
            c2, s2 = _direction(wx * along + wz * over, wz * along - wx * over, 0.0)
            c23, s23 = c2 * c_elbow - s2 * s_elbow, s2 * c_elbow + c2 * s_elbow
            miss_arm = miss + abs(upper * c2 + fore * c23 - wx) + abs(upper * s2 + fore * s23 - wz)
            _wrist_rotation(arm, c23, s23, c1, s1, G, N)
            angles[1], angles[2] = atan2(s2, c2), atan2(s_elbow, c_elbow)
            if miss_arm + _wrist_angles(N, free4, aligned_below, angles) <= accepted:
                row = 4 * shoulder + 2 * elbow
                aligned = angles[4] == 0.0 or angles[4] == pi
                for j in range(6):
                    sign, zero = arm[SIGNS + j], arm[ZEROS + j]
                    flip = _coordinate(sign, angles[j], zero)
                    other = -angles[j] if j == 4 else angles[j] + pi
                    out[row + 1, j] = flip
                    same = j < 3 or aligned
                    out[row, j] = flip if same else _coordinate(sign, other, zero)


def _in_arm(arm: Array, X: Array, column: int, weight: float) -> tuple[float, float, float]:
    """Return in J the direction (weight 0) or the point (weight 1) that a column of X_M holds in M."""
    a, b, c = arm[X_M + column], arm[X_M + 4 + column], arm[X_M + 8 + column]
    x = X[0, 0] * a + X[0, 1] * b + X[0, 2] * c + (X[0, 3] - arm[X_J + 3]) * weight
    y = X[1, 0] * a + X[1, 1] * b + X[1, 2] * c + (X[1, 3] - arm[X_J + 7]) * weight
    z = X[2, 0] * a + X[2, 1] * b + X[2, 2] * c + (X[2, 3] - arm[X_J + 11]) * weight
    return (
        arm[X_J] * x + arm[X_J + 4] * y + arm[X_J + 8] * z,
        arm[X_J + 1] * x + arm[X_J + 5] * y + arm[X_J + 9] * z,
        arm[X_J + 2] * x + arm[X_J + 6] * y + arm[X_J + 10] * z,
    )


def _direction(x: float, y: float, fallback: float) -> tuple[float, float]:
    """Return (cos, sin) of the direction of (x, y), or of `fallback` [rad] where it has none."""
    length = sqrt(x * x + y * y)
    if length == 0.0:
        return cos(fallback), sin(fallback)
    scale = 1.0 / length
    return x * scale, y * scale


def _wrist_rotation(arm: Array, c23: float, s23: float, c1: float, s1: float, G: Array, N: Array) -> None:
    """Write R_F·Ry(θ23)·Rz(-θ1)·G to N, both (9,) by rows."""
    for c in range(3):
        level = c1 * G[c] + s1 * G[3 + c]
        across = c1 * G[3 + c] - s1 * G[c]
        along = c23 * level + s23 * G[6 + c]
        over = c23 * G[6 + c] - s23 * level
        for r in range(3):
            at = R_F + 3 * r
            N[3 * r + c] = arm[at] * along + arm[at + 1] * across + arm[at + 2] * over


def _wrist_angles(N: Array, free4: float, aligned_below: float, angles: Array) -> float:
    """Write A, β >= 0, C with N = Rz(A)·Ry(β)·Rz(C) to angles 3 to 5; return the sum of entry errors."""
    sb = sqrt(N[2] * N[2] + N[5] * N[5])
    cb = N[8]
    aligned = sb < aligned_below
    if aligned:
        sb, cb = 0.0, (1.0 if cb > 0.0 else -1.0)
        cA, sA = cos(free4), sin(free4)
    else:
        cA, sA = N[2] / sb, N[5] / sb
    cb, sb = _direction(cb, sb, 0.0)
    cC, sC = _direction(cA * N[4] - sA * N[1], cA * N[3] - sA * N[0], 0.0)
    angles[3], angles[4], angles[5] = atan2(sA, cA), atan2(sb, cb), atan2(sC, cC)
    error: float = (
        abs(cA * cb * cC - sA * sC - N[0])
        + abs(-cA * cb * sC - sA * cC - N[1])
        + abs(cA * sb - N[2])
        + abs(sA * cb * cC + cA * sC - N[3])
        + abs(-sA * cb * sC + cA * cC - N[4])
        + abs(sA * sb - N[5])
        + abs(-sb * cC - N[6])
        + abs(sb * sC - N[7])
        + abs(cb - N[8])
    )
    return error


def _coordinate(sign: float, angle: float, zero: float) -> float:
    """Return sign·(angle - zero) in (-π, π]."""
    q = sign * (angle - zero)
    q -= 2.0 * pi * ceil((q - pi) * (0.5 / pi))
    return q if -pi < q < pi else pi  # rounding may leave ±π a bit outside
