"""Closed-form inverse kinematics of arms with three parallel axes, in plain loops that numba compiles.

The symbols are defined in `three_parallel.py`. Angles are carried as (cosine, sine) pairs; only the answer
takes an inverse tangent. Wrist: with N = Rz(-Θ1)·R_Jᵀ·R_BM·R_M the angles solve N = Ry(α)·Rz(β)·Ry(C). C
comes from the second row, then α from the third column of N·Ry(-C), which stays exact where β goes to 0 or π
and C alone loses its meaning (Euler angles as in Paul 1981).

Each row is checked by forward kinematics of the angles found; rows that miss the pose stay NaN. For an arm
that was snapped into the class the slacks are as wide as the snap: its rows are starts for `polish.py`.
"""

from math import atan2, ceil, cos, nan, pi, sin, sqrt

from ropsim.codegen import Array1, Array3, kernel
from ropsim.spatial import Array

WRIST_SLACK = 1e-10
"""With sin β below this, axes 2 and 6 count as parallel; the error made stays below the promised accuracy."""
REACH_SLACK = 1e-10
"""A cosine or a squared length [m²] this far beyond its bound is rounding at the edge of reach."""
AXIS_SLACK = 1e-10
"""A point P this near to axis 1 [m] lies on it."""

LENGTHS, ETA, SIGNS, ZEROS, X_J, X_M, SLACKS = 0, 6, 7, 13, 19, 31, 43
"""Where the fields of `ThreeParallelArm.flat` begin; frames lie by rows."""

ROOM = 33
"""Size of the work array, the first six joint coordinates that a singular pose keeps."""


@kernel
def inverse_rows(arm: Array1, room: Array1, T: Array3, out: Array3) -> None:
    """Write all branches of every pose X_BM in T (k, 4, 4) to out (k, 8, 6), NaN where absent.

    Args:
        arm: `ThreeParallelArm.flat`.
        room: joint coordinates [rad] of which q1 and q6 hold where the pose leaves them free (6 numbers), and
            room to work in; shape (ROOM,).
        T: poses.
        out: row 4·shoulder + 2·elbow + wrist holds that posture, angles in (-π, π].
    """
    a, h, D = arm[0], arm[1], arm[2]
    free1 = arm[SIGNS] * room[0] + arm[ZEROS]
    free6 = arm[SIGNS + 5] * room[5] + arm[ZEROS + 5]
    on_axis, beyond = arm[SLACKS + 1], arm[SLACKS + 3]
    G, N, wrist, angles = room[6:15], room[15:24], room[24:27], room[27:33]
    c_eta, s_eta = cos(arm[ETA]), sin(arm[ETA])
    for k in range(T.shape[0]):
        # P and M, turned by the constants, in frame J.
        X = T[k]
        for row in range(8):
            for j in range(6):
                out[k, row, j] = nan
        for c in range(3):
            G[c], G[3 + c], G[6 + c] = _in_arm(arm, X, c, 0.0)
        px, py, pz = _in_arm(arm, X, 3, 1.0)
        reach = px * px + py * py
        ahead = reach - D * D
        if not ahead >= -beyond:
            continue
        ahead = sqrt(max(ahead, 0.0))
        for shoulder in range(2):
            x = ahead if shoulder == 1 else -ahead
            if reach < on_axis * on_axis:
                c1, s1 = cos(free1), sin(free1)
            else:
                c1, s1 = _direction(px * x - py * D, py * x + px * D, free1)
            miss = abs(c1 * x + s1 * D - px) + abs(s1 * x - c1 * D - py)
            angles[0] = atan2(s1, c1)
            for c in range(3):
                N[c] = c1 * G[c] + s1 * G[3 + c]
                N[3 + c] = c1 * G[3 + c] - s1 * G[c]
                N[6 + c] = G[6 + c]
            miss += _wrist_angles(arm, N, free6, x - a, pz - h, wrist, angles)
            aligned = angles[4] == 0.0 or angles[4] == pi
            for flip in range(1, -1, -1):
                if flip == 0 and not aligned:  # the other posture of the wrist has α + π, -β, C + π
                    wrist[0], wrist[1], wrist[2] = wrist[0] + pi, -wrist[1], -wrist[2]
                    angles[4], angles[5] = -angles[4], angles[5] + pi
                wx = x - a - arm[LENGTHS + 5] * (c_eta * wrist[1] + s_eta * wrist[2])
                wz = pz - h - arm[LENGTHS + 5] * (s_eta * wrist[1] - c_eta * wrist[2])
                _planar_rows(arm, wx, wz, miss, wrist[0], angles, out[k], 4 * shoulder + flip)


def _planar_rows(
    arm: Array, wx: float, wz: float, miss: float, alpha: float, angles: Array, out: Array, row: int
) -> None:
    """Write both postures of the elbow that bring axis 4 to (wx, wz) from axis 2, the wrist at α."""
    upper, fore = arm[LENGTHS + 3], arm[LENGTHS + 4]
    accepted, beyond, least_bend = arm[SLACKS], arm[SLACKS + 3], arm[SLACKS + 4]
    c_elbow = (wx * wx + wz * wz - upper * upper - fore * fore) / (2.0 * upper * fore)
    if not abs(c_elbow) <= 1.0 + beyond:
        return
    c_elbow = min(1.0 - least_bend, max(least_bend - 1.0, c_elbow))
    s_bend = sqrt((1.0 - c_elbow) * (1.0 + c_elbow))
    bend = atan2(s_bend, c_elbow)
    for elbow in range(2):
        s_elbow = s_bend if elbow == row // 4 else -s_bend
        along, over = upper + fore * c_elbow, fore * s_elbow
        c2, s2 = _direction(wx * along + wz * over, wz * along - wx * over, 0.0)
        c23, s23 = c2 * c_elbow - s2 * s_elbow, s2 * c_elbow + c2 * s_elbow
        if miss + abs(upper * c2 + fore * c23 - wx) + abs(upper * s2 + fore * s23 - wz) > accepted:
            continue
        angles[1], angles[2] = atan2(s2, c2), (bend if elbow == row // 4 else -bend)
        angles[3] = -alpha - angles[1] - angles[2]
        for j in range(6):
            out[row + 2 * elbow, j] = _coordinate(arm[SIGNS + j], angles[j], arm[ZEROS + j])


def _wrist_angles(
    arm: Array, N: Array, free6: float, x: float, z: float, wrist: Array, angles: Array
) -> float:
    """Write α and β >= 0 and C with N = Ry(α)·Rz(β)·Ry(C); return the sum of entry errors.

    α, cos α and sin α go to `wrist`, the others to angles 4 and 5.
    """
    sb = sqrt(N[3] * N[3] + N[5] * N[5])
    cb = N[4]
    aligned = sb < arm[SLACKS + 2]
    if aligned:
        sb, cb = 0.0, (1.0 if cb > 0.0 else -1.0)
        cC, sC = cos(free6), sin(free6)
        ca, sa = _first_angle(N, cC, sC)
        target = atan2(sa, ca)
        shift = _reaching(arm, x, z, target) - target
        if shift != 0.0:  # α ± C is determined by the pose
            turned = free6 - shift * cb
            cC, sC = cos(turned), sin(turned)
    else:
        cC, sC = N[3] / sb, N[5] / sb
        cb, sb = _direction(cb, sb, 0.0)
    ca, sa = _first_angle(N, cC, sC)
    wrist[0], wrist[1], wrist[2] = atan2(sa, ca), ca, sa
    angles[4], angles[5] = atan2(sb, cb), atan2(sC, cC)
    error: float = (
        abs(ca * cb * cC - sa * sC - N[0])
        + abs(-ca * sb - N[1])
        + abs(ca * cb * sC + sa * cC - N[2])
        + abs(sb * cC - N[3])
        + abs(cb - N[4])
        + abs(sb * sC - N[5])
        + abs(-sa * cb * cC - ca * sC - N[6])
        + abs(sa * sb - N[7])
        + abs(-sa * cb * sC + ca * cC - N[8])
    )
    return error


def _first_angle(N: Array, cC: float, sC: float) -> tuple[float, float]:
    """Return (cos α, sin α) from the third column of N·Ry(-C), which is Ry(α)·e_z."""
    return _direction(N[8] * cC - N[6] * sC, N[2] * cC - N[0] * sC, 0.0)


def _reaching(arm: Array, x: float, z: float, alpha: float) -> float:
    """Return the angle nearest to α at which upper arm and forearm reach axis 4; α where none does."""
    upper, fore, end = arm[LENGTHS + 3], arm[LENGTHS + 4], arm[LENGTHS + 5]
    wx, wz = x - end * cos(arm[ETA] - alpha), z - end * sin(arm[ETA] - alpha)
    apart = sqrt(wx * wx + wz * wz)
    wanted = min(max(apart, abs(upper - fore)), upper + fore)
    span = x * x + z * z
    if wanted == apart or span * end * end == 0.0:
        return alpha
    c = (span + end * end - wanted * wanted) / (2.0 * sqrt(span) * end)
    if not abs(c) <= 1.0:
        return alpha
    to_point = atan2(z, x)
    over = sin(arm[ETA] - alpha - to_point)
    turn = atan2(sqrt((1.0 - c) * (1.0 + c)), c)
    turned: float = arm[ETA] - to_point - (turn if over >= 0.0 else -turn)
    return turned


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
    """Return (cos, sin) of the direction of (x, y), or of `fallback` [rad] if it is undefined."""
    length = sqrt(x * x + y * y)
    if length == 0.0:
        return cos(fallback), sin(fallback)
    scale = 1.0 / length
    return x * scale, y * scale


def _coordinate(sign: float, angle: float, zero: float) -> float:
    """Return sign·(angle - zero) in (-π, π]."""
    q = sign * (angle - zero)
    q -= 2.0 * pi * ceil((q - pi) * (0.5 / pi))
    return q if -pi < q < pi else pi  # rounding may leave ±π a bit outside
