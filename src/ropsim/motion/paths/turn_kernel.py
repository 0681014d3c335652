"""The turn of the tool between two orientations, in plain numbers that numba compiles."""

from math import atan2, sin, sqrt

from ropsim.codegen import Array1, kernel
from ropsim.spatial import Array

STRAIGHT = 1e-12
"""A smaller sine of an angle says that two vectors are in line."""


@kernel
def turn_between(start: Array1, end: Array1, drives: int, out: Array1) -> None:
    """Write axis, angle and roll of the turn from one orientation to another; sources at `plan_turn`.

    Args:
        start: unit quaternion (w, x, y, z) of the start, shape (4,).
        end: of the end, shape (4,).
        drives: 1 for the drive transform, 0 for a fixed axis.
        out: where the unit axis in the frame of the start goes, then angle and roll [rad], shape (5,).
    """
    sw, sx, sy, sz = start[0], -start[1], -start[2], -start[3]
    ew, ex, ey, ez = end[0], end[1], end[2], end[3]
    w = sw * ew - sx * ex - sy * ey - sz * ez
    x = sw * ex + sx * ew + sy * ez - sz * ey
    y = sw * ey - sx * ez + sy * ew + sz * ex
    z = sw * ez + sx * ey - sy * ex + sz * ew
    length = sqrt(w * w + x * x + y * y + z * z)
    length = -length if w < 0.0 else length
    w, x, y, z = w / length, x / length, y / length, z / length
    out[0], out[1], out[2], out[3], out[4] = 0.0, 0.0, 1.0, 0.0, 0.0
    if drives:
        _swing_and_roll(w, x, y, z, out)
        return
    sine = sqrt(x * x + y * y + z * z)
    if sine != 0.0:
        out[0], out[1], out[2] = x / sine, y / sine, z / sine
        out[3] = 2.0 * atan2(sine, w)


def _swing_and_roll(w: float, x: float, y: float, z: float, out: Array) -> None:
    """Write them for the orientation of the end in the frame of the start."""
    # columns x and z of its rotation; the latter is the approach vector of the goal
    along = (1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y))
    goal = (2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y))
    sine = sqrt(goal[0] * goal[0] + goal[1] * goal[1])
    # z × goal has no z; where both are in line any axis normal to z will do
    a, b = (-goal[1] / sine, goal[0] / sine) if sine > STRAIGHT else (0.0, 1.0)
    angle = atan2(sine, goal[2])
    rising, versine = sin(angle), 2.0 * sin(0.5 * angle) * sin(0.5 * angle)
    # x and y of the swung frame in that of the start
    swung_x = (1.0 - versine * b * b, versine * a * b, -rising * b)
    swung_y = (versine * a * b, 1.0 - versine * a * a, rising * a)
    across = swung_y[0] * along[0] + swung_y[1] * along[1] + swung_y[2] * along[2]
    ahead = swung_x[0] * along[0] + swung_x[1] * along[1] + swung_x[2] * along[2]
    out[0], out[1], out[2], out[3], out[4] = a, b, 0.0, angle, atan2(across, ahead)
