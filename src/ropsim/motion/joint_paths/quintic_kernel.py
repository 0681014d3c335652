"""Polynomials between the rows of traced paths, and motions along them, for all joints at a time."""

from ropsim.codegen import Array1, Array2, Array3, columns, kernel
from ropsim.spatial import Array

COEFFICIENTS = 13
"""Of a polynomial of degree five and of its derivatives."""


@kernel
def traced_points(
    rows: Array2, d1: Array2, d2: Array2, parameters: Array1, s: Array1, work: Array2, out: Array3
) -> None:
    """Write coordinates and derivatives by the path parameter s between rows (quintic Hermite interpolation).

    Args:
        rows: shape (k, n).
        d1: first derivatives by the path parameter, shape (k, n).
        d2: second ones.
        parameters: path parameters of the rows, rising from 0, shape (k,).
        s: path parameters, best in order, shape (m,).
        work: to work in, shape (COEFFICIENTS, n).
        out: where all goes, shape (3, m, n).
    """
    known, n = -1, rows.shape[1]
    for k in range(s.shape[0]):
        row = _row_at(parameters, s[k], known)
        step = parameters[row + 1] - parameters[row]
        if row != known:
            known = row
            _between(rows, d1, d2, row, step, work)
        t, per_unit = (s[k] - parameters[row]) / step, 1.0 / step
        _quintics(n, t, per_unit, 1.0, 0.0, work, out[0, k], out[1, k], out[2, k])


@kernel
def traced_middles(rows: Array2, d1: Array2, d2: Array2, parameters: Array1, error: Array1) -> None:
    """Write how far the polynomials through every second row pass the others, which are midway between.

    There a quintic is the mean of both rows with 5/32 of the difference of their first derivatives and 1/64
    of the sum of the second ones, by the distance of the rows.

    Args:
        rows: shape (2·m + 1, n).
        d1: as for `traced_points`.
        d2: see there.
        parameters: see there.
        error: where the greatest distance of a coordinate at each row between goes, shape (m,).
    """
    for k in range(error.shape[0]):
        one, other, most = 2 * k, 2 * k + 2, 0.0
        step = parameters[other] - parameters[one]
        for j in range(rows.shape[1]):
            slope, bend = d1[one, j] - d1[other, j], d2[one, j] + d2[other, j]
            q = 0.5 * (rows[one, j] + rows[other, j]) + step * (0.15625 * slope + 0.015625 * step * bend)
            most = max(most, abs(q - rows[one + 1, j]))
        error[k] = most


@kernel
def traced_in_time(
    rows: Array2,
    d1: Array2,
    d2: Array2,
    parameters: Array1,
    law: Array2,
    first: int,
    until: int,
    work: Array2,
    at: int,
    total: Array3,
) -> None:
    """Write coordinates and derivatives by time at times of a motion.

    With the path parameter s, its speed v and acceleration a, q' = dq/ds·v and q'' = d²q/ds²·v² + dq/ds·a.

    Args:
        rows: as for `traced_points`.
        d1: see there.
        d2: see there.
        parameters: see there.
        law: path parameters, best in order, speeds and accelerations in its rows 1 to 3, shape (4 or more,
            m).
        first: number of the first time.
        until: number behind that of the last one.
        work: to work in, shape (COEFFICIENTS, n).
        at: row of the motion for the time 0 of the law.
        total: the motion, of which rows at + first to at + until are written, shape (3, m, n).
    """
    known, n = -1, rows.shape[1]
    for k in range(first, until):
        row = _row_at(parameters, law[1, k], known)
        step = parameters[row + 1] - parameters[row]
        if row != known:
            known = row
            _between(rows, d1, d2, row, step, work)
        t, v, a = (law[1, k] - parameters[row]) / step, law[2, k], law[3, k]
        _quintics(n, t, 1.0 / step, v, a, work, total[0, at + k], total[1, at + k], total[2, at + k])


def _row_at(parameters: Array, s: float, known: int) -> int:
    """Return the row behind which a path parameter lies, at the end of the path the last but one.

    Args:
        parameters: of the rows, rising.
        s: path parameter.
        known: row of another one that is probably near, -1 for none.
    """
    last = parameters.shape[0] - 2
    low, high = 0, last
    if known >= 0 and s >= parameters[known]:
        if known == last or s < parameters[known + 1]:
            return known
        if known + 1 == last or s < parameters[known + 2]:
            return known + 1
        low = known + 2
    while low < high:
        middle = (low + high + 1) // 2
        if parameters[middle] <= s:
            low = middle
        else:
            high = middle - 1
    return low


def _between(rows: Array, d1: Array, d2: Array, row: int, step: float, work: Array) -> None:
    """Write the coefficients of the polynomials between a row and the next one by the share of the step."""
    after = row + 1
    _coefficients(rows.shape[1], step, rows[row], rows[after], d1[row], d1[after], d2[row], d2[after], work)


@columns
def _coefficients(
    count: int,
    step: float,
    start: Array,
    end: Array,
    v0: Array,
    v1: Array,
    a0: Array,
    a1: Array,
    work: Array,
) -> None:
    """Write the coefficients of t⁰ to t⁵, then of the first and of the second derivative from t¹ on."""
    for j in range(count):
        gap = end[j] - start[j]
        v = step * v0[j]
        w = step * v1[j]
        a = 0.5 * step * step * a0[j]
        b = 0.5 * step * step * a1[j]
        c3 = 10.0 * gap - 6.0 * v - 4.0 * w - 3.0 * a + b
        c4 = -15.0 * gap + 8.0 * v + 7.0 * w + 3.0 * a - 2.0 * b
        c5 = 6.0 * gap - 3.0 * (v + w) - a + b
        work[0, j] = start[j]
        work[1, j] = v
        work[2, j] = a
        work[3, j] = c3
        work[4, j] = c4
        work[5, j] = c5
        work[6, j] = 2.0 * a
        work[7, j] = 3.0 * c3
        work[8, j] = 4.0 * c4
        work[9, j] = 5.0 * c5
        work[10, j] = 6.0 * c3
        work[11, j] = 12.0 * c4
        work[12, j] = 20.0 * c5


@columns
def _quintics(
    count: int, t: float, per_unit: float, v: float, a: float, work: Array, q: Array, qd: Array, qdd: Array
) -> None:
    """Write the polynomials at t, traversed with the speed v and the acceleration a."""
    for j in range(count):
        c1 = work[1, j]
        b1 = work[6, j]
        q[j] = work[0, j] + t * (c1 + t * (work[2, j] + t * (work[3, j] + t * (work[4, j] + t * work[5, j]))))
        d1 = per_unit * (c1 + t * (b1 + t * (work[7, j] + t * (work[8, j] + t * work[9, j]))))
        d2 = per_unit * per_unit * (b1 + t * (work[10, j] + t * (work[11, j] + t * work[12, j])))
        qd[j] = d1 * v
        qdd[j] = d2 * (v * v) + d1 * a
