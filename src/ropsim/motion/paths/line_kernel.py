"""The tool on a straight line in plain loops that numba compiles.

The coefficients of a rotation about an axis (Rodrigues' formula) are among the numbers of a line, so that
each evaluation costs two sines.
"""

from math import hypot, sin, sqrt

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.motion.curves.path import STANDS, STILL
from ropsim.motion.paths.turn_kernel import turn_between
from ropsim.spatial import Array

ROUNDING = 1e-14
"""A turn between equal orientations is that of the rounding of their product [rad]."""

START, END, DISPLACEMENT, SWINGS, VELOCITY, R_END, AXIS, ANGLE, ROLL, LINE_LENGTH, MOVES, LINE_SIZE = (
    0, 3, 6, 9, 36, 39, 48, 51, 52, 53, 54, 55,
)  # fmt: skip
"""Where the numbers of a line begin: positions of both ends and the displacement between them [m], then
R_start·(I, K, K²) by rows with K the cross product matrix of the axis, the angular velocity of the swing by
the share of the path [rad], R_end by rows, the axis in the frame of the start, angle and roll [rad], length,
1 where the TCP moves.
"""


@kernel
def line_numbers(
    start: Array1, turned_start: Array1, end: Array1, turned_end: Array1, drives: int, out: Array1
) -> None:
    """Write the numbers of a line.

    Args:
        start: position of its start [m], shape (3,).
        turned_start: orientation there (w, x, y, z), shape (4,).
        end: position of its end [m], shape (3,).
        turned_end: orientation there, shape (4,).
        drives: 1 for the drive transform, 0 for a fixed axis.
        out: where they go, shape (LINE_SIZE,).
    """
    square = 0.0
    for i in range(3):
        out[START + i], out[END + i], out[DISPLACEMENT + i] = start[i], end[i], end[i] - start[i]
        square += out[DISPLACEMENT + i] * out[DISPLACEMENT + i]
    turn_between(turned_start, turned_end, drives, out[AXIS : ROLL + 1])
    size = hypot(out[ANGLE], out[ROLL])
    if not size > ROUNDING:
        out[ANGLE], out[ROLL], size = 0.0, 0.0, 0.0
    distance = sqrt(square)
    out[MOVES] = 1.0 if distance > STANDS else 0.0
    out[LINE_LENGTH] = distance if distance > STANDS else size if size > STILL else 0.0
    _write_rotation(turned_end, out[R_END:AXIS])
    R = out[SWINGS : SWINGS + 9]
    _write_rotation(turned_start, R)
    x, y, z = out[AXIS], out[AXIS + 1], out[AXIS + 2]
    for i in range(3):
        a, b, c = R[3 * i], R[3 * i + 1], R[3 * i + 2]
        K = (b * z - c * y, c * x - a * z, a * y - b * x)  # of the row of R·K
        first, second = SWINGS + 9 + 3 * i, SWINGS + 18 + 3 * i
        out[first], out[first + 1], out[first + 2] = K[0], K[1], K[2]
        out[second] = K[1] * z - K[2] * y
        out[second + 1] = K[2] * x - K[0] * z
        out[second + 2] = K[0] * y - K[1] * x
        out[VELOCITY + i] = (a * x + b * y + c * z) * out[ANGLE]


@kernel
def straight_points(numbers: Array1, s: Array1, matrices: Array3, d1: Array2, d2: Array2) -> None:
    """Write the tool and its derivatives at path parameters of a line; the end pose is exact to the bit.

    Args:
        numbers: of the line.
        s: path parameters, shape (k,).
        matrices: where the poses go, shape (k, 4, 4).
        d1: where first derivatives go, shape (k, 6).
        d2: where second derivatives go, shape (k, 6).
    """
    length, roll = numbers[LINE_LENGTH], numbers[ROLL]
    share = 1.0 / length if length > 0.0 else 0.0
    v0, v1, v2 = numbers[VELOCITY], numbers[VELOCITY + 1], numbers[VELOCITY + 2]
    for k in range(s.shape[0]):
        X = matrices[k]
        r = s[k] / length if length > 0.0 else s[k] * 0.0
        rising, versine = _rodrigues(r * numbers[ANGLE])
        for i in range(3):
            X[i, 3] = (1.0 - r) * numbers[START + i] + r * numbers[END + i]
            d1[k, i], d2[k, i] = numbers[DISPLACEMENT + i] * share, 0.0
            d1[k, 3 + i], d2[k, 3 + i] = numbers[VELOCITY + i] * share, 0.0
            for j in range(3):
                at = SWINGS + 3 * i + j
                X[i, j] = numbers[at] + rising * numbers[at + 9] + versine * numbers[at + 18]
        if roll != 0.0:  # about the approach vector, which the swing takes along
            a0, a1, a2 = roll * X[0, 2], roll * X[1, 2], roll * X[2, 2]
            d1[k, 3] += a0 * share
            d1[k, 4] += a1 * share
            d1[k, 5] += a2 * share
            d2[k, 3] = (v1 * a2 - v2 * a1) * (share * share)
            d2[k, 4] = (v2 * a0 - v0 * a2) * (share * share)
            d2[k, 5] = (v0 * a1 - v1 * a0) * (share * share)
            rising, versine = _rodrigues(r * roll)
            for i in range(3):
                x, y = X[i, 0], X[i, 1]
                X[i, 0] = x * (1.0 - versine) + y * rising
                X[i, 1] = y * (1.0 - versine) - x * rising
        if r == 1.0:
            for i in range(3):
                for j in range(3):
                    X[i, j] = numbers[R_END + 3 * i + j]
        X[3, 0] = X[3, 1] = X[3, 2] = 0.0
        X[3, 3] = 1.0


def _rodrigues(angle: float) -> tuple[float, float]:
    """Return sin φ and 1 - cos φ."""
    half = sin(0.5 * angle)
    return sin(angle), 2.0 * half * half


def _write_rotation(q: Array, R: Array) -> None:
    """Write the rotation of a unit quaternion by rows, as `Pose.write_matrix` does."""
    w, x, y, z = q[0], q[1], q[2], q[3]
    R[0], R[1], R[2] = 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)
    R[3], R[4], R[5] = 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)
    R[6], R[7], R[8] = 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)
