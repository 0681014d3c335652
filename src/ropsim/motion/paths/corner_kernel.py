"""The polynomials of a corner between two poses, in plain loops that numba compiles."""

from math import atan2, sqrt

from ropsim.codegen import kernel
from ropsim.motion.paths.curve_kernel import rate_rows, turning_rows
from ropsim.spatial import Array

LOOKS = 64
"""Steps in which the turn of the tool is looked at."""


@kernel(
    "void(f8[:,::1], f8[:,:,::1], f8[:,::1], f8[:,::1], f8[::1], f8[:,::1],"
    " f8[:,:,::1], f8[:,:,::1], f8[::1])"
)
def corner_polynomials(
    series: Array,
    matrices: Array,
    d1: Array,
    d2: Array,
    scales: Array,
    room: Array,
    coefficients: Array,
    middles: Array,
    told: Array,
) -> None:
    """Write the quintic Hermite polynomials of position and rotation vector between two ends.

    Args:
        series: `rotation_vector.series`.
        matrices: poses of the tool at both ends, shape (2, 4, 4).
        d1: first derivatives by the way there, shape (2, 6).
        d2: second ones.
        scales: ds/du at both ends, shape (2,).
        room: to work in, shape (15, 3).
        coefficients: where those of u⁰ to u⁵ go, shape (1, 6, 6).
        middles: where the orientation goes that rotation vectors count from, shape (1, 3, 3).
        told: where the greatest of these goes [rad], shape (1,).
    """
    half, still, middle = room[0:1], room[1:2], middles[0]
    _logarithm(matrices, room[2:6], half[0])
    for i in range(3):
        half[0, i] *= 0.5
        still[0, i] = 0.0
    turning_rows(series, half, still, still, middles, room[3:4], room[4:5])  # exp of the half, for now
    for j in range(3):
        x, y, z = middle[0, j], middle[1, j], middle[2, j]
        for i in range(3):
            room[2 + i, j] = matrices[0, i, 0] * x + matrices[0, i, 1] * y + matrices[0, i, 2] * z
    for i in range(3):
        for j in range(3):
            middle[i, j] = room[2 + i, j]
    vectors, speed, change, rate, bend = room[5:7], room[7:9], room[9:11], room[11:13], room[13:15]
    for end in range(2):
        c = scales[end]
        for i in range(3):
            vectors[end, i] = half[0, i] if end else -half[0, i]
            w = a = 0.0
            for k in range(3):
                w += d1[end, 3 + k] * middle[k, i]
                a += d2[end, 3 + k] * middle[k, i]
            speed[end, i], change[end, i] = w * c, a * (c * c)
    rate_rows(series, vectors, speed, change, rate, bend)
    C = coefficients[0]
    one, other = scales[0], scales[1]
    for i in range(3):
        _quintic(
            C, i, matrices[0, i, 3], d1[0, i] * one, d2[0, i] * (one * one),
            matrices[1, i, 3], d1[1, i] * other, d2[1, i] * (other * other),
        )  # fmt: skip
        _quintic(C, 3 + i, vectors[0, i], rate[0, i], bend[0, i], vectors[1, i], rate[1, i], bend[1, i])
    told[0] = _greatest_turn(C)


def _quintic(C: Array, column: int, x: float, v: float, a: float, y: float, w: float, b: float) -> None:
    """Write a column of coefficients from value, first and second derivative at u = 0 and at u = 1."""
    C[0, column], C[1, column], C[2, column] = x, v, 0.5 * a
    C[3, column] = -10.0 * x - 6.0 * v - 1.5 * a + 10.0 * y - 4.0 * w + 0.5 * b
    C[4, column] = 15.0 * x + 8.0 * v + 1.5 * a - 15.0 * y + 7.0 * w - b
    C[5, column] = -6.0 * x - 3.0 * v - 0.5 * a + 6.0 * y - 3.0 * w + 0.5 * b


def _greatest_turn(C: Array) -> float:
    """Return the greatest length of rotation vectors where it is looked; NaN where one is none."""
    greatest = 0.0
    for look in range(LOOKS + 1):
        u, square = look / LOOKS, 0.0
        for i in range(3, 6):
            value = 0.0
            for k in range(5, -1, -1):
                value = value * u + C[k, i]
            square += value * value
        if not square <= greatest:
            greatest = square
    return sqrt(greatest)


def _logarithm(matrices: Array, room: Array, vector: Array) -> None:
    """Write the rotation vector, of at most half a turn, from the first to the second orientation (3,) [rad].

    By the quaternion whose largest component divides the others (Shepperd 1978).
    """
    for i in range(3):
        for j in range(3):
            total = 0.0
            for k in range(3):
                total += matrices[0, k, i] * matrices[1, k, j]
            room[i, j] = total
    trace = room[0, 0] + room[1, 1] + room[2, 2]
    w, largest, axis = 1.0 + trace, 1.0 + trace, -1
    for i in range(3):
        square = 1.0 + 2.0 * room[i, i] - trace
        if square > largest:
            largest, axis = square, i
    x, y, z = room[2, 1] - room[1, 2], room[0, 2] - room[2, 0], room[1, 0] - room[0, 1]
    if axis == 0:
        w, x, y, z = x, largest, room[1, 0] + room[0, 1], room[0, 2] + room[2, 0]
    elif axis == 1:
        w, x, y, z = y, room[1, 0] + room[0, 1], largest, room[2, 1] + room[1, 2]
    elif axis == 2:
        w, x, y, z = z, room[0, 2] + room[2, 0], room[2, 1] + room[1, 2], largest
    size = sqrt(w * w + x * x + y * y + z * z)
    if w < 0.0:
        size = -size
    w, x, y, z = w / size, x / size, y / size, z / size
    sine = sqrt(x * x + y * y + z * z)
    ratio = 2.0 * atan2(sine, w) / sine if sine > 0.0 else 2.0
    vector[0], vector[1], vector[2] = ratio * x, ratio * y, ratio * z
