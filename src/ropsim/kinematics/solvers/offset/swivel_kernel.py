"""Closed-form inverse kinematics of arms with a swivel angle, in plain loops that numba compiles.

The symbols are defined in `swivel.py`. Turns of shoulder and wrist are Rz(A)·Ry(B)·Rz(C); as in
`spherical_wrist_kernel.py` A comes from the third column and C from the second row of Rz(-A)·N, which stays
exact where B goes to 0 or π. Each row is checked by forward kinematics; for an arm that was snapped into the
class the slacks are as wide as the snap, and its rows are starts for `polish.py`.
"""

from math import atan2, ceil, cos, nan, pi, sin, sqrt

from ropsim.codegen import Array1, Array3, kernel
from ropsim.spatial import Array

ALIGNED_SLACK = 1e-10
"""With sin B below this, the outer axes of a shoulder or wrist count as aligned."""
REACH_SLACK = 1e-10
"""A cosine this far beyond its bound is rounding at the edge of reach."""
STEEP = 1e-9
"""A line from S to W this near to the direction of axis 1 [rad] has no plane with it."""

ZEROS, HEIGHT, U, R, AXIS, LENGTHS, PHI, SHOULDER, WRIST = 0, 7, 8, 11, 14, 17, 20, 21, 39
X_J, X_M, SLACKS = 57, 69, 81
"""Where the fields of `SwivelArm.flat` begin; frames lie by rows."""


@kernel
def inverse_rows(arm: Array1, room: Array1, swivels: Array1, T: Array3, out: Array3) -> None:
    """Write all branches of every pose X_BM in T (k, 4, 4) to out (k, 8, 7), NaN where absent.

    Args:
        arm: `SwivelArm.flat`.
        room: joint coordinates [rad] of which q1 and q5 hold where the pose leaves them free (7 numbers), and
            room to work in; shape (80,).
        swivels: swivel angle of each pose [rad], shape (k,).
        T: poses.
        out: row 4·shoulder + 2·elbow + wrist holds that posture, angles in (-π, π].
    """
    G, Q, N, E, w = room[7:16], room[16:25], room[25:34], room[34:43], room[43:46]
    one, other, angles = room[46:55], room[55:64], room[64:71]
    along, upper, fore = arm[LENGTHS], arm[LENGTHS + 1], arm[LENGTHS + 2]
    for k in range(T.shape[0]):
        X = T[k]
        for row in range(8):
            for j in range(7):
                out[k, row, j] = nan
        for c in range(3):
            G[c], G[3 + c], G[6 + c] = _in_arm(arm, X, c, 0.0)
        w[0], w[1], w[2] = _in_arm(arm, X, 3, 1.0)
        w[2] -= arm[HEIGHT]
        span = w[0] * w[0] + w[1] * w[1] + w[2] * w[2]
        c_bend = (span - along * along - upper * upper - fore * fore) / (2.0 * upper * fore)
        if not abs(c_bend) <= 1.0 + arm[SLACKS + 2] or span == 0.0:
            continue
        least = arm[SLACKS + 3]
        c_bend = min(1.0 - least, max(least - 1.0, c_bend))
        s_bend = sqrt((1.0 - c_bend) * (1.0 + c_bend))
        for elbow in range(2):
            side = 1.0 if elbow == 0 else -1.0
            angles[3] = atan2(side * s_bend, c_bend)
            miss = _upper_arm(arm, w, side, swivels[k], angles[3], one, other, E, Q)
            _wrist_turn(arm, Q, E, G, one, N)
            miss += _three_angles(N, room[4] + arm[ZEROS + 4], arm[SLACKS + 1], angles, 4)
            _between(arm, SHOULDER, Q, one, N)
            miss += _three_angles(N, room[0] + arm[ZEROS], arm[SLACKS + 1], angles, 0)
            if miss <= arm[SLACKS]:
                for row in range(4):
                    _write(arm, angles, row // 2, row % 2, out[k, 4 * (row // 2) + 2 * elbow + row % 2])


def _upper_arm(
    arm: Array,
    w: Array,
    side: float,
    swivel: float,
    bend: float,
    body: Array,
    space: Array,
    E: Array,
    Q: Array,
) -> float:
    """Write the turn of the forearm about axis 4 to E, of the upper arm to Q; return the miss of w."""
    ax, ay, az = arm[AXIS], arm[AXIS + 1], arm[AXIS + 2]
    c, s = cos(bend - arm[PHI]), sin(bend - arm[PHI])
    v = 1.0 - c
    E[0], E[1], E[2] = c + ax * ax * v, ax * ay * v - az * s, ax * az * v + ay * s
    E[3], E[4], E[5] = ay * ax * v + az * s, c + ay * ay * v, ay * az * v - ax * s
    E[6], E[7], E[8] = az * ax * v - ay * s, az * ay * v + ax * s, c + az * az * v
    for i in range(3):
        at = 3 * i
        body[i] = arm[U + i] + E[at] * arm[R] + E[at + 1] * arm[R + 1] + E[at + 2] * arm[R + 2]
        body[3 + i] = side * arm[AXIS + i]
        space[i] = w[i]
    level = sqrt(w[0] * w[0] + w[1] * w[1])
    space[3], space[4], space[5] = 0.0, 1.0, 0.0
    if level > STEEP * abs(w[2]):
        space[3], space[4] = -w[1] / level, w[0] / level
    missed = _frame(body) - _frame(space)
    c, s = cos(swivel), sin(swivel)
    for i in range(3):
        n, b = space[3 + i], space[6 + i]
        space[3 + i], space[6 + i] = c * n + s * b, c * b - s * n
    for i in range(3):
        for j in range(3):
            Q[3 * i + j] = space[i] * body[j] + space[3 + i] * body[3 + j] + space[6 + i] * body[6 + j]
    return abs(missed)


def _frame(F: Array) -> float:
    """Make F (9,) a frame, its first vector in the old direction; return the length of that."""
    length = sqrt(F[0] * F[0] + F[1] * F[1] + F[2] * F[2])
    for i in range(3):
        F[i] /= length
    along = F[0] * F[3] + F[1] * F[4] + F[2] * F[5]
    for i in range(3):
        F[3 + i] -= along * F[i]
    across = sqrt(F[3] * F[3] + F[4] * F[4] + F[5] * F[5])
    for i in range(3):
        F[3 + i] /= across
    F[6], F[7], F[8] = F[1] * F[5] - F[2] * F[4], F[2] * F[3] - F[0] * F[5], F[0] * F[4] - F[1] * F[3]
    return length


def _wrist_turn(arm: Array, Q: Array, E: Array, G: Array, one: Array, N: Array) -> None:
    """Write the turn of the wrist, (Q·E)ᵀ·G between its bases, to N."""
    for i in range(3):
        for j in range(3):
            one[3 * i + j] = Q[3 * i] * E[j] + Q[3 * i + 1] * E[3 + j] + Q[3 * i + 2] * E[6 + j]
    for i in range(3):
        for j in range(3):
            N[3 * i + j] = one[i] * G[j] + one[3 + i] * G[3 + j] + one[6 + i] * G[6 + j]
    for i in range(9):
        E[i] = N[i]
    _between(arm, WRIST, E, one, N)


def _between(arm: Array, at: int, M: Array, one: Array, N: Array) -> None:
    """Write Kᵀ·M·L to N, with K and L at a place of the arm."""
    for i in range(3):
        for j in range(3):
            one[3 * i + j] = arm[at + i] * M[j] + arm[at + 3 + i] * M[3 + j] + arm[at + 6 + i] * M[6 + j]
    for i in range(3):
        for j in range(3):
            x, y, z = arm[at + 9 + j], arm[at + 12 + j], arm[at + 15 + j]
            N[3 * i + j] = one[3 * i] * x + one[3 * i + 1] * y + one[3 * i + 2] * z


def _three_angles(N: Array, free: float, aligned_below: float, angles: Array, at: int) -> float:
    """Write A, B >= 0, C with N = Rz(A)·Ry(B)·Rz(C) to three angles; return the sum of entry errors."""
    sb = sqrt(N[2] * N[2] + N[5] * N[5])
    cb = N[8]
    if sb < aligned_below:
        sb, cb = 0.0, (1.0 if cb > 0.0 else -1.0)
        cA, sA = cos(free), sin(free)
    else:
        cA, sA = N[2] / sb, N[5] / sb
    length = sqrt(cb * cb + sb * sb)
    cb, sb = cb / length, sb / length
    cC, sC = cA * N[4] - sA * N[1], cA * N[3] - sA * N[0]
    length = sqrt(cC * cC + sC * sC)
    cC, sC = cC / length, sC / length
    angles[at], angles[at + 1], angles[at + 2] = atan2(sA, cA), atan2(sb, cb), atan2(sC, cC)
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


def _write(arm: Array, angles: Array, shoulder: int, wrist: int, q: Array) -> None:
    """Write the coordinates of one posture of shoulder and wrist; others have A ± π, -B, C ± π."""
    for j in range(7):
        angle = angles[j]
        middle = 1 if j < 3 else 5
        other = shoulder == 0 if j < 3 else wrist == 0 and j > 3
        if other and 0.0 < angles[middle] < pi:
            angle = -angle if j == middle else angle + pi
        value = angle - arm[ZEROS + j]
        value -= 2.0 * pi * ceil((value - pi) * (0.5 / pi))
        q[j] = value if -pi < value < pi else pi  # rounding may leave ±π a bit outside


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
