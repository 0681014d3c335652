"""Two links in a plane: closed-form inverse kinematics of SCARA arms and planar two-link arms.

The symbols are defined in `planar_arm.py`. Rows are written wherever the point in the plane can be reached;
forward kinematics checks afterwards whether the whole pose is.
"""

from math import atan2, ceil, cos, nan, pi, sin, sqrt

from ropsim.codegen import Array1, Array3, kernel
from ropsim.spatial import Array

LENGTHS, JOINTS, SIGNS, ZEROS, X_J, R_M, OFFSET, SLACKS = 0, 2, 6, 10, 14, 26, 35, 37
"""Where the fields of `PlanarArm.flat` begin; frames lie by rows."""


@kernel
def planar_rows(arm: Array1, near: Array1, T: Array3, out: Array3) -> None:
    """Write both branches of every pose X_BM in T (k, 4, 4) to out (k, 2, n), NaN where absent.

    Args:
        arm: `PlanarArm.flat`.
        near: joint coordinates [rad | m] of which the first turning one holds where the pose leaves it free,
            shape (n,).
        T: poses.
        out: row 0 with the second link bent in the positive sense about axis 1, row 1 in the negative one.
    """
    L1, L2, beyond, least_bend = arm[LENGTHS], arm[LENGTHS + 1], arm[SLACKS], arm[SLACKS + 1]
    first, second, third, slide = int(arm[2]), int(arm[3]), int(arm[4]), int(arm[5])
    for k in range(T.shape[0]):
        X = T[k]
        for row in range(2):
            for j in range(out.shape[2]):
                out[k, row, j] = nan
        x, y, z = _point(arm, X)
        psi = _turn(arm, X)
        if third >= 0:
            c, s = cos(psi), sin(psi)
            x -= c * arm[OFFSET] - s * arm[OFFSET + 1]
            y -= s * arm[OFFSET] + c * arm[OFFSET + 1]
        span = x * x + y * y
        c_bend = (span - L1 * L1 - L2 * L2) / (2.0 * L1 * L2)
        if not abs(c_bend) <= 1.0 + beyond:
            continue
        c_bend = min(1.0 - least_bend, max(least_bend - 1.0, c_bend))
        s_bend = sqrt((1.0 - c_bend) * (1.0 + c_bend))
        for row in range(2):
            side = s_bend if row == 0 else -s_bend
            along, over, bend = L1 + L2 * c_bend, L2 * side, atan2(side, c_bend)
            theta = near[first] + arm[ZEROS]
            if third < 0:  # a folded two-link arm: the rotation decides, since the position does not
                theta = psi - bend - arm[ZEROS + 2]
            if span > beyond * beyond * L1 * L2:
                theta = atan2(y * along - x * over, x * along + y * over)
            _write(arm, out[k, row], 0, first, theta)
            _write(arm, out[k, row], 1, second, bend)
            if third >= 0:
                _write(arm, out[k, row], 2, third, psi - theta - bend)
                out[k, row, slide] = arm[SIGNS + 3] * (z - arm[ZEROS + 3])


def _point(arm: Array, X: Array) -> tuple[float, float, float]:
    """Return the origin of M in J [m]."""
    x, y, z = X[0, 3] - arm[X_J + 3], X[1, 3] - arm[X_J + 7], X[2, 3] - arm[X_J + 11]
    return (
        arm[X_J] * x + arm[X_J + 4] * y + arm[X_J + 8] * z,
        arm[X_J + 1] * x + arm[X_J + 5] * y + arm[X_J + 9] * z,
        arm[X_J + 2] * x + arm[X_J + 6] * y + arm[X_J + 10] * z,
    )


def _turn(arm: Array, X: Array) -> float:
    """Return by how much M is turned about the z axis of J against coordinate zero [rad]."""
    c = s = 0.0
    for r in range(3):
        x = arm[X_J] * X[0, r] + arm[X_J + 4] * X[1, r] + arm[X_J + 8] * X[2, r]
        y = arm[X_J + 1] * X[0, r] + arm[X_J + 5] * X[1, r] + arm[X_J + 9] * X[2, r]
        c += x * arm[R_M + r] + y * arm[R_M + 3 + r]
        s += y * arm[R_M + r] - x * arm[R_M + 3 + r]
    return atan2(s, c)


def _write(arm: Array, q: Array, role: int, joint: int, angle: float) -> None:
    """Write the coordinate of a joint that has an angle, in (-π, π] [rad]."""
    value = arm[SIGNS + role] * (angle - arm[ZEROS + role])
    value -= 2.0 * pi * ceil((value - pi) * (0.5 / pi))
    q[joint] = value if -pi < value < pi else pi  # rounding may leave ±π a bit outside
