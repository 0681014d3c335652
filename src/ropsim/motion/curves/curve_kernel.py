"""Curves of polynomials in compiled loops: position, arc length and orientation of the tool.

Rotation vectors θ follow positions: coefficients have six columns, p [m] and θ [rad]. Functions of x = |θ|²
are power series (`rotation_vector.series`), whose rows are c₁ = sin|θ| / |θ|, c₂ = (1 - cos|θ|) / |θ|², c₃ =
(|θ| - sin|θ|) / |θ|³, the derivatives of c₂ and c₃ by x, and (c₂ - c₁ / 2) / x.
"""

from math import sqrt

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.spatial import Array

_Vector = tuple[float, float, float]
LEAST = 1e-17
"""Of |θ|²: below it, the functions have their values at 0."""
AT_HAND = 6
"""Number of steps tried one by one before a binary search."""
SOME = 12
"""Terms for |θ| below 1 rad; the rest is below 1e-24 of the first one."""


@kernel
def turning_rows(
    series: Array2, vectors: Array2, d1: Array2, d2: Array2, R: Array3, speed: Array2, change: Array2
) -> None:
    """Write exp(K), ω and ω' of rows of θ, θ' and θ'', shapes (k, 3, 3) and (k, 3)."""
    for k in range(vectors.shape[0]):
        v = (vectors[k, 0], vectors[k, 1], vectors[k, 2])
        rate, bend = (d1[k, 0], d1[k, 1], d1[k, 2]), (d2[k, 0], d2[k, 1], d2[k, 2])
        c = _functions(series, _dot(v, v))
        _write_rotation(c[0], c[1], v, R[k])
        w, a = _turning(c[0], c[1], c[2], c[3], c[4], v, rate, bend)
        for i in range(3):
            speed[k, i], change[k, i] = w[i], a[i]


@kernel
def rate_rows(series: Array2, vectors: Array2, speed: Array2, change: Array2, d1: Array2, d2: Array2) -> None:
    """Write θ' and θ'' of rows of θ, ω and ω', shapes (k, 3): the inverse of `turning_rows`."""
    for k in range(vectors.shape[0]):
        v = (vectors[k, 0], vectors[k, 1], vectors[k, 2])
        c = _functions(series, _dot(v, v))
        inverse = c[5] / c[1]
        rate = _untwisted(inverse, v, (speed[k, 0], speed[k, 1], speed[k, 2]))
        _, rest = _turning(c[0], c[1], c[2], c[3], c[4], v, rate, (0.0, 0.0, 0.0))
        bend = _untwisted(
            inverse, v, (change[k, 0] - rest[0], change[k, 1] - rest[1], change[k, 2] - rest[2])
        )
        for i in range(3):
            d1[k, i], d2[k, i] = rate[i], bend[i]


@kernel
def curve_points(
    series: Array2,
    ends: Array1,
    inverse: Array2,
    steps: int,
    coefficients: Array3,
    middles: Array3,
    s: Array1,
    matrices: Array3,
    d1: Array2,
    d2: Array2,
) -> None:
    """Write the tool and its derivatives by the arc length at arc lengths s.

    Args:
        series: see above.
        ends: arc length at the end of each step, and 0 before them, shape (m + 1,).
        inverse: coefficients of t over the share of each step, shape (m, 6).
        steps: of each segment; m = c·steps.
        coefficients: of the segments, shape (c, 6, 6).
        middles: orientations that θ counts from, shape (c, 3, 3).
        s: shape (k,).
        matrices: where the poses go, shape (k, 4, 4).
        d1: where first derivatives go, shape (k, 6).
        d2: where second derivatives go, shape (k, 6).
    """
    step, segment, turns = 0, -1, True
    for k in range(s.shape[0]):
        step = _step_from(ends, s[k], step)
        t = _parameter(ends, inverse, step, s[k])
        if segment < 0 or (coefficients.shape[0] > 1 and step // steps != segment):
            segment = step // steps
            turns = _turns(coefficients[segment])
        C, M, X = coefficients[segment], middles[segment], matrices[k]
        for i in range(3):
            X[i, 3], d1[k, i], d2[k, i] = _polynomial(C, i, t)
        p1, p2 = (d1[k, 0], d1[k, 1], d1[k, 2]), (d2[k, 0], d2[k, 1], d2[k, 2])
        square = _dot(p1, p1)
        first, second = 1.0 / sqrt(square), -_dot(p1, p2) / (square * square)  # dt/ds, d²t/ds²
        if not turns:
            for i in range(3):
                d1[k, i], d2[k, i] = p1[i] * first, p2[i] * first * first + p1[i] * second
                d1[k, 3 + i] = d2[k, 3 + i] = 0.0
            _stand(M, X)
            continue
        v0, r0, b0 = _polynomial(C, 3, t)
        v1, r1, b1 = _polynomial(C, 4, t)
        v2, r2, b2 = _polynomial(C, 5, t)
        v = (v0, v1, v2)
        c = _functions(series, _dot(v, v))
        _write_rotation(c[0], c[1], v, X)
        w, a = _turning(c[0], c[1], c[2], c[3], c[4], v, (r0, r1, r2), (b0, b1, b2))
        for i in range(3):
            d1[k, i], d2[k, i] = p1[i] * first, p2[i] * first * first + p1[i] * second
            speed = M[i, 0] * w[0] + M[i, 1] * w[1] + M[i, 2] * w[2]
            change = M[i, 0] * a[0] + M[i, 1] * a[1] + M[i, 2] * a[2]
            d1[k, 3 + i], d2[k, 3 + i] = speed * first, change * first * first + speed * second
        _turn_by(M, X)


@kernel
def curve_at(coefficients: Array3, u: Array1, p: Array2, d1: Array2, d2: Array2) -> None:
    """Write positions and their derivatives by t at u, the number of the segment and t in it as one."""
    for k in range(u.shape[0]):
        segment = min(max(int(u[k]), 0), coefficients.shape[0] - 1)
        for i in range(3):
            p[k, i], d1[k, i], d2[k, i] = _polynomial(coefficients[segment], i, u[k] - segment)


@kernel
def speed_range(coefficients: Array3, steps: int, work: Array1, out: Array2) -> None:
    """Write the least and the greatest |p'| at the ends of the steps of each segment, shape (c, 2).

    Args:
        coefficients: of the segments, shape (c, 6, 6).
        steps: of each segment.
        work: to work in, shape (2·steps + 2,).
        out: where they go.
    """
    t, speeds = work[: steps + 1], work[steps + 1 : 2 * steps + 2]
    for step in range(steps + 1):
        t[step] = step / steps
    for segment in range(coefficients.shape[0]):
        _write_speeds(coefficients[segment], t, speeds)
        out[segment, 0] = out[segment, 1] = speeds[0]
        for step in range(1, steps + 1):
            out[segment, 0] = min(out[segment, 0], speeds[step])
            out[segment, 1] = max(out[segment, 1], speeds[step])


@kernel
def arc_length_of_steps(
    coefficients: Array3,
    steps: int,
    points: Array1,
    weights: Array1,
    work: Array1,
    ends: Array1,
    inverse: Array2,
) -> None:
    """Write the arc length at the end of each step, and t over the share of the step.

    Args:
        coefficients: of the segments, shape (c, 6, 6).
        steps: of each segment.
        points: of the quadrature in [0, 1], shape (g,).
        weights: of these, shape (g,).
        work: to work in, shape (3·steps + 3,).
        ends: where the arc lengths go, and 0 before them, shape (c·steps + 1,).
        inverse: where the coefficients of t go, shape (c·steps, 6).
    """
    t, firsts = work[: steps + 1], work[steps + 1 : 2 * steps + 2]
    seconds, speeds = work[2 * steps + 2 : 3 * steps + 3], work[steps + 1 : 2 * steps + 1]
    ends[0] = 0.0
    for segment in range(coefficients.shape[0]):
        C, row = coefficients[segment], segment * steps
        lengths = ends[row + 1 : row + 1 + steps]
        for step in range(steps):
            lengths[step] = 0.0
        for g in range(points.shape[0]):
            for step in range(steps):
                t[step] = (step + points[g]) / steps
            _write_speeds(C, t[:steps], speeds)
            for step in range(steps):
                lengths[step] += weights[g] * speeds[step]
        for step in range(steps + 1):
            t[step] = step / steps
        _write_rates(C, t, firsts, seconds)
        for step in range(steps):
            length = lengths[step] / steps
            v, a = firsts[step] * length, seconds[step] * length * length
            w, b, gap = firsts[step + 1] * length, seconds[step + 1] * length * length, t[step + 1] - t[step]
            own = inverse[row + step]
            own[0], own[1], own[2] = t[step], v, 0.5 * a
            own[3] = 10.0 * gap - 6.0 * v - 4.0 * w - 1.5 * a + 0.5 * b
            own[4] = -15.0 * gap + 8.0 * v + 7.0 * w + 1.5 * a - b
            own[5] = 6.0 * gap - 3.0 * (v + w) - 0.5 * (a - b)
            ends[row + step + 1] = ends[row + step] + length


def _write_speeds(C: Array, t: Array, out: Array) -> None:
    """Write |p'| at many t side by side."""
    x1, x2, x3, x4, x5 = C[1, 0], C[2, 0], C[3, 0], C[4, 0], C[5, 0]
    y1, y2, y3, y4, y5 = C[1, 1], C[2, 1], C[3, 1], C[4, 1], C[5, 1]
    z1, z2, z3, z4, z5 = C[1, 2], C[2, 2], C[3, 2], C[4, 2], C[5, 2]
    for i in range(t.shape[0]):
        x, _ = _slope(x1, x2, x3, x4, x5, t[i])
        y, _ = _slope(y1, y2, y3, y4, y5, t[i])
        z, _ = _slope(z1, z2, z3, z4, z5, t[i])
        out[i] = sqrt(x * x + y * y + z * z)


def _write_rates(C: Array, t: Array, firsts: Array, seconds: Array) -> None:
    """Write dt/ds and d²t/ds² at many t side by side."""
    x1, x2, x3, x4, x5 = C[1, 0], C[2, 0], C[3, 0], C[4, 0], C[5, 0]
    y1, y2, y3, y4, y5 = C[1, 1], C[2, 1], C[3, 1], C[4, 1], C[5, 1]
    z1, z2, z3, z4, z5 = C[1, 2], C[2, 2], C[3, 2], C[4, 2], C[5, 2]
    for i in range(t.shape[0]):
        x, a = _slope(x1, x2, x3, x4, x5, t[i])
        y, b = _slope(y1, y2, y3, y4, y5, t[i])
        z, c = _slope(z1, z2, z3, z4, z5, t[i])
        square = x * x + y * y + z * z
        firsts[i] = 1.0 / sqrt(square)
        seconds[i] = -(x * a + y * b + z * c) / (square * square)


def _slope(c1: float, c2: float, c3: float, c4: float, c5: float, t: float) -> tuple[float, float]:
    """Return first and second derivative of a polynomial by its coefficients; see `_polynomial`."""
    value = c5 * t + c4
    rate = c5 * t + value
    half = c5 * t + rate
    value = value * t + c3
    rate = rate * t + value
    half = half * t + rate
    value = value * t + c2
    rate = rate * t + value
    return rate * t + (value * t + c1), 2.0 * (half * t + rate)


def _polynomial(C: Array, column: int, t: float) -> _Vector:
    """Return value, first and second derivative of a column of coefficients (6, n)."""
    value = rate = half = 0.0
    for k in range(5, -1, -1):
        half = half * t + rate
        rate = rate * t + value
        value = value * t + C[k, column]
    return value, rate, 2.0 * half


def _step_of(ends: Array, s: float) -> int:
    """Return the last step that begins at s or before, the first one for values before all."""
    low, high = 0, ends.shape[0] - 1
    while high - low > 1:
        middle = (low + high) // 2
        if ends[middle] <= s:
            low = middle
        else:
            high = middle
    return low


def _step_from(ends: Array, s: float, step: int) -> int:
    """Return the result of `_step_of`, quickly if it is shortly behind a step."""
    if ends[step] <= s:
        for near in range(step, min(step + AT_HAND, ends.shape[0] - 1)):
            if s < ends[near + 1]:
                return near
    return _step_of(ends, s)


def _parameter(ends: Array, inverse: Array, step: int, s: float) -> float:
    share = (s - ends[step]) / (ends[step + 1] - ends[step])
    t = 0.0
    for k in range(5, -1, -1):
        t = t * share + inverse[step, k]
    return t


def _turns(C: Array) -> bool:
    """Return whether the tool turns along a segment, or is turned all along it."""
    turns = False
    for k in range(C.shape[0]):
        turns = turns or not (C[k, 3] == 0.0 and C[k, 4] == 0.0 and C[k, 5] == 0.0)
    return turns


def _functions(series: Array, x: float) -> tuple[float, float, float, float, float, float]:
    """Return the six functions of x, by as many terms as have a say in the last bit."""
    c1 = c2 = c3 = c2_x = c3_x = rest = 0.0
    for k in range(_terms(series, x) - 1, -1, -1):
        c1 = c1 * x + series[0, k]
        c2 = c2 * x + series[1, k]
        c3 = c3 * x + series[2, k]
        c2_x = c2_x * x + series[3, k]
        c3_x = c3_x * x + series[4, k]
        rest = rest * x + series[5, k]
    return c1, c2, c3, c2_x, c3_x, rest


def _terms(series: Array, x: float) -> int:
    """Return how many terms have a say in the last bit."""
    return 1 if x < LEAST else SOME if x < 1.0 else series.shape[1]


def _turning(
    c1: float, c2: float, c3: float, c2_x: float, c3_x: float, v: _Vector, rate: _Vector, bend: _Vector
) -> tuple[_Vector, _Vector]:
    """Return ω and ω' as sums of θ, θ', θ'', θ×θ' and θ×θ''."""
    along = _dot(v, rate)
    turned, bent = _cross(v, rate), _cross(v, bend)
    grown = 2.0 * along * c3_x
    to_v = c3 * (_dot(v, bend) + _dot(rate, rate)) + grown * along
    to_rate = -c3 * along - grown * _dot(v, v)
    to_turned = 2.0 * along * c2_x
    by_v = c3 * along
    w = (
        c1 * rate[0] + c2 * turned[0] + by_v * v[0],
        c1 * rate[1] + c2 * turned[1] + by_v * v[1],
        c1 * rate[2] + c2 * turned[2] + by_v * v[2],
    )
    a = (
        c1 * bend[0] + c2 * bent[0] + to_v * v[0] + to_rate * rate[0] + to_turned * turned[0],
        c1 * bend[1] + c2 * bent[1] + to_v * v[1] + to_rate * rate[1] + to_turned * turned[1],
        c1 * bend[2] + c2 * bent[2] + to_v * v[2] + to_rate * rate[2] + to_turned * turned[2],
    )
    return w, a


def _untwisted(inverse: float, v: _Vector, w: _Vector) -> _Vector:
    """Return θ' of ω: w - v×w / 2 + inverse·v×(v×w)."""
    once = _cross(v, w)
    twice = _cross(v, once)
    return (
        w[0] - 0.5 * once[0] + inverse * twice[0],
        w[1] - 0.5 * once[1] + inverse * twice[1],
        w[2] - 0.5 * once[2] + inverse * twice[2],
    )


def _write_rotation(c1: float, c2: float, v: _Vector, R: Array) -> None:
    """Write exp(K) = I + c₁·K + c₂·K² to the first three rows and columns of R."""
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        R[i, i] = 1.0 - c2 * (v[j] * v[j] + v[k] * v[k])
        R[k, j] = c2 * v[j] * v[k] + c1 * v[i]
        R[j, k] = c2 * v[j] * v[k] - c1 * v[i]


def _stand(M: Array, X: Array) -> None:
    """Write the axes of a pose that is not turned, and its last row."""
    for i in range(3):
        X[i, 0], X[i, 1], X[i, 2], X[3, i] = M[i, 0], M[i, 1], M[i, 2], 0.0
    X[3, 3] = 1.0


def _turn_by(M: Array, X: Array) -> None:
    """Turn the axes of a pose, whose last row is also written."""
    for j in range(3):
        x, y, z = X[0, j], X[1, j], X[2, j]
        for i in range(3):
            X[i, j] = M[i, 0] * x + M[i, 1] * y + M[i, 2] * z
    X[3, 0] = X[3, 1] = X[3, 2] = 0.0
    X[3, 3] = 1.0


def _dot(a: _Vector, b: _Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: _Vector, b: _Vector) -> _Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
