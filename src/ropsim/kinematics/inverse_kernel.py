"""Closed-form inverse kinematics of arms with spherical wrist, in plain loops that numba compiles.

The symbols are those of `wrist.py`. Angles are carried as (cosine, sine) pairs; only the answer takes an
inverse tangent. Wrist: with N = R_F·Ry(θ23)·Rz(-θ1)·R_Jᵀ·R_BM·R_M the angles of axes 4 to 6 solve
N = Rz(A)·Ry(β)·Rz(C). A comes from the third column, then C from the second row of Rz(-A)·N, which stays
exact where β goes to 0 or π and A alone loses its meaning (Euler angles as in Paul 1981).

Each row is checked by forward kinematics of the angles found; rows that miss the pose stay NaN.
"""

from math import atan2, ceil, cos, pi, sin, sqrt

from ropsim.codegen import kernel
from ropsim.spatial import Array

POSE_SLACK = 1e-9
"""Largest sum of the errors of an accepted row [m, entries of the rotation matrix]: the promised accuracy."""
REACH_SLACK = 1e-10
"""A cosine or a squared length [m²] this far beyond its bound is rounding at the edge of reach."""
WRIST_SLACK = 1e-10
"""With sin β below this, axes 4 and 6 count as aligned; the error made stays below `POSE_SLACK`."""


@kernel(
    "void(f8[::1], f8[::1], f8[::1], f8, f8[:,::1], f8[:,::1], f8[:,::1], f8[::1],"
    " f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[::1])"
)
def inverse_rows(
    lengths: Array,
    signs: Array,
    zeros: Array,
    front: float,
    X_J: Array,
    X_M: Array,
    R_F: Array,
    free: Array,
    T: Array,
    out: Array,
    rotations: Array,
    angles: Array,
) -> None:
    """Write all branches of every pose X_BM in T (k, 4, 4) to out (k, 8, 6), filled with NaN before.

    The first seven arguments are the fields of `WristArm`. `free` (6,) gives q1 and q4 [rad] where the
    pose leaves them free; `rotations` (2, 3, 3) and `angles` (6,) are room to work in.
    Row 4·shoulder + 2·elbow + wrist holds that posture, angles in (-π, π].
    """
    a1, h, D, upper, fore = lengths[0], lengths[1], lengths[2], lengths[3], lengths[4]
    free1, free4 = signs[0] * free[0] + zeros[0], signs[3] * free[3] + zeros[3]
    N, G = rotations[0], rotations[1]
    for k in range(T.shape[0]):
        # Wrist centre and M, turned by the constants, in frame J.
        X = T[k]
        for c in range(3):
            G[0, c], G[1, c], G[2, c] = _in_arm(X_J, X, X_M[:, c], 0.0)
        px, py, pz = _in_arm(X_J, X, X_M[:, 3], 1.0)
        wz = pz - h
        reach = px * px + py * py
        ahead = reach - D * D
        if not ahead >= -REACH_SLACK:
            continue
        ahead = sqrt(max(ahead, 0.0))
        for shoulder in range(2):
            x = front * ahead if shoulder == 1 else -front * ahead
            wx = x - a1
            span = wx * wx + wz * wz
            c_elbow = (span - upper * upper - fore * fore) / (2.0 * upper * fore)
            if not abs(c_elbow) <= 1.0 + REACH_SLACK:
                continue
            c_elbow = min(1.0, max(-1.0, c_elbow))
            s_bend = sqrt((1.0 - c_elbow) * (1.0 + c_elbow))
            c1, s1 = _direction(px * x - py * D, py * x + px * D, free1)
            miss = abs(c1 * x + s1 * D - px) + abs(s1 * x - c1 * D - py)
            angles[0] = atan2(s1, c1)
            for elbow in range(2):
                s_elbow = front * s_bend if elbow == shoulder else -front * s_bend
                along, over = upper + fore * c_elbow, fore * s_elbow
                c2, s2 = _direction(wx * along + wz * over, wz * along - wx * over, 0.0)
                c23, s23 = c2 * c_elbow - s2 * s_elbow, s2 * c_elbow + c2 * s_elbow
                miss_arm = miss + abs(upper * c2 + fore * c23 - wx) + abs(upper * s2 + fore * s23 - wz)
                _wrist_rotation(R_F, c23, s23, c1, s1, G, N)
                angles[1], angles[2] = atan2(s2, c2), atan2(s_elbow, c_elbow)
                if miss_arm + _wrist_angles(N, free4, angles) <= POSE_SLACK:
                    row = 4 * shoulder + 2 * elbow
                    aligned = angles[4] == 0.0 or angles[4] == pi
                    for j in range(6):
                        flip = _coordinate(signs[j], angles[j], zeros[j])
                        other = -angles[j] if j == 4 else angles[j] + pi
                        out[k, row + 1, j] = flip
                        same = j < 3 or aligned
                        out[k, row, j] = flip if same else _coordinate(signs[j], other, zeros[j])


def _in_arm(X_J: Array, X: Array, v: Array, weight: float) -> tuple[float, float, float]:
    """Return in J the direction (weight 0) or the point (weight 1) that has the coordinates v (3,) in M."""
    x = X[0, 0] * v[0] + X[0, 1] * v[1] + X[0, 2] * v[2] + (X[0, 3] - X_J[0, 3]) * weight
    y = X[1, 0] * v[0] + X[1, 1] * v[1] + X[1, 2] * v[2] + (X[1, 3] - X_J[1, 3]) * weight
    z = X[2, 0] * v[0] + X[2, 1] * v[1] + X[2, 2] * v[2] + (X[2, 3] - X_J[2, 3]) * weight
    return (
        X_J[0, 0] * x + X_J[1, 0] * y + X_J[2, 0] * z,
        X_J[0, 1] * x + X_J[1, 1] * y + X_J[2, 1] * z,
        X_J[0, 2] * x + X_J[1, 2] * y + X_J[2, 2] * z,
    )


def _direction(x: float, y: float, fallback: float) -> tuple[float, float]:
    """Return (cos, sin) of the direction of (x, y), or of `fallback` [rad] where it has none."""
    length = sqrt(x * x + y * y)
    if length == 0.0:
        return cos(fallback), sin(fallback)
    scale = 1.0 / length
    return x * scale, y * scale


def _wrist_rotation(R_F: Array, c23: float, s23: float, c1: float, s1: float, G: Array, N: Array) -> None:
    """Write R_F·Ry(θ23)·Rz(-θ1)·G to N."""
    for c in range(3):
        level = c1 * G[0, c] + s1 * G[1, c]
        across = c1 * G[1, c] - s1 * G[0, c]
        along = c23 * level + s23 * G[2, c]
        over = c23 * G[2, c] - s23 * level
        for r in range(3):
            N[r, c] = R_F[r, 0] * along + R_F[r, 1] * across + R_F[r, 2] * over


def _wrist_angles(N: Array, free4: float, angles: Array) -> float:
    """Write A, β >= 0, C with N = Rz(A)·Ry(β)·Rz(C) to angles 3 to 5; return the sum of entry errors."""
    sb = sqrt(N[0, 2] * N[0, 2] + N[1, 2] * N[1, 2])
    cb = N[2, 2]
    aligned = sb < WRIST_SLACK
    if aligned:
        sb, cb = 0.0, (1.0 if cb > 0.0 else -1.0)
        cA, sA = cos(free4), sin(free4)
    else:
        cA, sA = N[0, 2] / sb, N[1, 2] / sb
    cb, sb = _direction(cb, sb, 0.0)
    cC, sC = _direction(cA * N[1, 1] - sA * N[0, 1], cA * N[1, 0] - sA * N[0, 0], 0.0)
    angles[3], angles[4], angles[5] = atan2(sA, cA), atan2(sb, cb), atan2(sC, cC)
    error: float = (
        abs(cA * cb * cC - sA * sC - N[0, 0])
        + abs(-cA * cb * sC - sA * cC - N[0, 1])
        + abs(cA * sb - N[0, 2])
        + abs(sA * cb * cC + cA * sC - N[1, 0])
        + abs(-sA * cb * sC + cA * cC - N[1, 1])
        + abs(sA * sb - N[1, 2])
        + abs(-sb * cC - N[2, 0])
        + abs(sb * sC - N[2, 1])
        + abs(cb - N[2, 2])
    )
    return error


def _coordinate(sign: float, angle: float, zero: float) -> float:
    """Return sign·(angle - zero) in (-π, π]."""
    q = sign * (angle - zero)
    q -= 2.0 * pi * ceil((q - pi) * (0.5 / pi))
    return q if -pi < q < pi else pi  # rounding may leave ±π a bit outside
