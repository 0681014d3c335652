"""A blend between two poses, its polynomials and its arc length, in plain loops that numba compiles."""

from math import atan2, sqrt
from typing import NamedTuple

import numpy as np

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.motion.curves.curve_kernel import arc_length_of_steps, rate_rows, speed_range, turning_rows
from ropsim.spatial import Array

SAMPLES = 64
"""Steps in which the turn of the tool and the speed of the polynomials are sampled."""
MADE, NO_LENGTH, TURNS_BACK, WHIRLS = range(4)
"""What became of a blend."""
UNIT = 1e-6
"""By which a tangent may differ from a unit vector."""
SHARPEST = -0.98481
"""Cosine of 170°."""
SLOWEST = 0.05
"""Least |p'| of the speeds at both ends; a blend of two lines by 170° has 0.087."""
UNEVEN = 0.45
"""Least |p'| by its greatest; below, steps are four times as fine."""
FULL_TURN = 6.283185307179586


class Rules(NamedTuple):
    """Constants of a blend.

    Attributes:
        series: `rotation_vector.series`.
        points: of the quadrature, as for `arc_length_of_steps`.
        weights: of the same shape.
        swing: ds/du at the ends of a blend that does not turn, as a multiple of the distance to its point.
        steps: of the arc length, for a blend of even speed.
    """

    series: Array2
    points: Array1
    weights: Array1
    swing: float
    steps: int


class PathEnd(NamedTuple):
    """A path of the tool where the blend leaves or enters it.

    Attributes:
        pose: of the tool, shape (1, 4, 4).
        d1: first derivatives by the path parameter, shape (1, 6).
        d2: second ones.
    """

    pose: Array3
    d1: Array2
    d2: Array2


class BlendWork(NamedTuple):
    """Work buffers.

    Attributes:
        matrices: shape (2, 4, 4).
        rates: shape (5, 6).
        buffer: shape (15, 3).
        parameters: shape (3·steps + 3,), at least 2·`SAMPLES` + 2.
    """

    matrices: Array3
    rates: Array2
    buffer: Array2
    parameters: Array1

    @classmethod
    def of(cls, steps: int) -> "BlendWork":
        """Return buffers for so many steps of the arc length."""
        return cls(np.empty((2, 4, 4)), np.empty((5, 6)), np.empty((15, 3)), np.empty(3 * steps + 3))


class BlendRows(NamedTuple):
    """The blend.

    Attributes:
        coefficients: of u⁰ to u⁵, shape (1, 6, 6).
        middles: the orientation that rotation vectors count from, shape (1, 3, 3).
        ends: of the arc length, as for `arc_length_of_steps`, if the steps suffice.
        inverse: of the same shape.
    """

    coefficients: Array3
    middles: Array3
    ends: Array1
    inverse: Array2


@kernel
def blend_curve_rows(
    rules: Rules, before: PathEnd, after: PathEnd, work: BlendWork, out: BlendRows, state: Array1
) -> None:
    """Write the blend from one path of the tool to the next, or why there is none.

    Args:
        rules: constants.
        before: where the tool leaves the path before.
        after: where it enters the path behind.
        work: buffers.
        out: the blend.
        state: lengths of both paths up to the point where they meet [m]; becomes the result as above, and
            the number of steps that it needs: these or four times as many, shape (2,).
    """
    series, points, weights, swing, steps = rules
    matrices, rates, buffer, parameters = work
    coefficients, middles, ends, inverse = out
    d1, d2, scales, speeds = rates[0:2], rates[2:4], rates[4, 0:2], rates[4:5, 2:4]
    for i in range(4):
        for j in range(4):
            matrices[0, i, j], matrices[1, i, j] = before.pose[0, i, j], after.pose[0, i, j]
    for i in range(6):
        d1[0, i], d1[1, i] = before.d1[0, i], after.d1[0, i]
        d2[0, i], d2[1, i] = before.d2[0, i], after.d2[0, i]
    cosine = d1[0, 0] * d1[1, 0] + d1[0, 1] * d1[1, 1] + d1[0, 2] * d1[1, 2]
    scale = swing * sqrt(sqrt(max(0.5 + 0.5 * cosine, 0.0)))
    if not (_is_unit(d1[0]) and _is_unit(d1[1])):
        state[0] = NO_LENGTH
        return
    if cosine < SHARPEST:
        state[0] = TURNS_BACK
        return
    scales[0], scales[1] = scale * state[0], scale * state[1]
    slowest = SLOWEST * min(scales[0], scales[1])
    blend_polynomials(series, matrices, d1, d2, scales, buffer, coefficients, middles, state)
    if not state[0] <= FULL_TURN:
        state[0] = WHIRLS
        return
    speed_range(coefficients, SAMPLES, parameters, speeds)
    if not speeds[0, 0] > slowest:
        state[0] = TURNS_BACK
        return
    count = 4 * steps if speeds[0, 0] < UNEVEN * speeds[0, 1] else steps
    if count == inverse.shape[0]:
        arc_length_of_steps(coefficients, count, points, weights, parameters, ends, inverse)
    state[0], state[1] = MADE, count


def _is_unit(tangent: Array) -> bool:
    x, y, z = tangent[0], tangent[1], tangent[2]
    return abs(sqrt(x * x + y * y + z * z) - 1.0) <= UNIT


@kernel
def blend_polynomials(
    series: Array2,
    matrices: Array3,
    d1: Array2,
    d2: Array2,
    scales: Array1,
    work: Array2,
    coefficients: Array3,
    middles: Array3,
    result: Array1,
) -> None:
    """Write the quintic Hermite polynomials of position and rotation vector between two ends.

    Args:
        series: `rotation_vector.series`.
        matrices: poses of the tool at both ends, shape (2, 4, 4).
        d1: first derivatives by the path parameter there, shape (2, 6).
        d2: second ones.
        scales: ds/du at both ends, shape (2,).
        work: to work in, shape (15, 3).
        coefficients: where those of u⁰ to u⁵ go, shape (1, 6, 6).
        middles: where the orientation goes that rotation vectors count from, shape (1, 3, 3).
        result: where the greatest of these goes [rad], shape (1,).
    """
    half, still, middle = work[0:1], work[1:2], middles[0]
    _logarithm(matrices, work[2:6], half[0])
    for i in range(3):
        half[0, i] *= 0.5
        still[0, i] = 0.0
    turning_rows(series, half, still, still, middles, work[3:4], work[4:5])  # exp of the half, for now
    for j in range(3):
        x, y, z = middle[0, j], middle[1, j], middle[2, j]
        for i in range(3):
            work[2 + i, j] = matrices[0, i, 0] * x + matrices[0, i, 1] * y + matrices[0, i, 2] * z
    for i in range(3):
        for j in range(3):
            middle[i, j] = work[2 + i, j]
    vectors, speed, change, rate, bend = work[5:7], work[7:9], work[9:11], work[11:13], work[13:15]
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
    result[0] = _greatest_turn(C)


def _quintic(C: Array, column: int, x: float, v: float, a: float, y: float, w: float, b: float) -> None:
    """Write a column of coefficients from value, first and second derivative at u = 0 and at u = 1."""
    C[0, column], C[1, column], C[2, column] = x, v, 0.5 * a
    C[3, column] = -10.0 * x - 6.0 * v - 1.5 * a + 10.0 * y - 4.0 * w + 0.5 * b
    C[4, column] = 15.0 * x + 8.0 * v + 1.5 * a - 15.0 * y + 7.0 * w - b
    C[5, column] = -6.0 * x - 3.0 * v - 0.5 * a + 6.0 * y - 3.0 * w + 0.5 * b


def _greatest_turn(C: Array) -> float:
    """Return the greatest length of rotation vectors at the samples; NaN where one is none."""
    greatest = 0.0
    for sample in range(SAMPLES + 1):
        u, square = sample / SAMPLES, 0.0
        for i in range(3, 6):
            value = 0.0
            for k in range(5, -1, -1):
                value = value * u + C[k, i]
            square += value * value
        if not square <= greatest:
            greatest = square
    return sqrt(greatest)


def _logarithm(matrices: Array, work: Array, vector: Array) -> None:
    """Write the rotation vector, of at most half a turn, from the first to the second orientation (3,) [rad].

    By the quaternion whose largest component divides the others (Shepperd 1978).
    """
    for i in range(3):
        for j in range(3):
            total = 0.0
            for k in range(3):
                total += matrices[0, k, i] * matrices[1, k, j]
            work[i, j] = total
    trace = work[0, 0] + work[1, 1] + work[2, 2]
    w, largest, axis = 1.0 + trace, 1.0 + trace, -1
    for i in range(3):
        square = 1.0 + 2.0 * work[i, i] - trace
        if square > largest:
            largest, axis = square, i
    x, y, z = work[2, 1] - work[1, 2], work[0, 2] - work[2, 0], work[1, 0] - work[0, 1]
    if axis == 0:
        w, x, y, z = x, largest, work[1, 0] + work[0, 1], work[0, 2] + work[2, 0]
    elif axis == 1:
        w, x, y, z = y, work[1, 0] + work[0, 1], largest, work[2, 1] + work[1, 2]
    elif axis == 2:
        w, x, y, z = z, work[0, 2] + work[2, 0], work[2, 1] + work[1, 2], largest
    size = sqrt(w * w + x * x + y * y + z * z)
    if w < 0.0:
        size = -size
    w, x, y, z = w / size, x / size, y / size, z / size
    sine = sqrt(x * x + y * y + z * z)
    ratio = 2.0 * atan2(sine, w) / sine if sine > 0.0 else 2.0
    vector[0], vector[1], vector[2] = ratio * x, ratio * y, ratio * z
