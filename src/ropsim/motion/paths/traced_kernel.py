"""Traced paths in plain loops that numba compiles: derivatives at the rows, polynomials between them."""

from ropsim.codegen import columns, kernel
from ropsim.spatial import Array

COEFFICIENTS = 13
"""Of a polynomial of degree five and of its derivatives."""
HALF = 3
"""So many rows on either side weigh in the derivatives of one; those at the ends have others."""


@kernel("void(f8[:,::1], f8[:,::1], f8[:,:,::1], f8[:,:,::1])")
def row_differences(rows: Array, inner: Array, sided: Array, out: Array) -> None:
    """Write the first and second derivative of every row, by the number of the row.

    Args:
        rows: at equidistant places, shape (k, n).
        inner: weights of the seven rows around a row, shape (2, 7).
        sided: weights of the first v rows at each of them, shape (2, v, v); the last v rows have them, too.
        out: where the derivatives go, shape (2, k, n).
    """
    _differences(rows, inner, sided, out)


@kernel(
    "void(f8[:,::1], f8[:,::1], f8[:,:,::1], f8, f8[:,:,::1], f8[:,::1], f8[:,:,::1], f8[::1])",
)
def rows_with_roughness(
    rows: Array,
    inner: Array,
    sided: Array,
    length: float,
    out: Array,
    coarse: Array,
    coarse_out: Array,
    rough: Array,
) -> None:
    """Write the derivatives of every row, and how far the path through every second row passes the others.

    Args:
        rows: at equidistant places, shape (2·m + 1, n).
        inner: weights as for `row_differences`.
        sided: likewise; v is no more than m + 1.
        length: of the way from the first row to the last.
        out: where the derivatives go, shape (2, 2·m + 1, n).
        coarse: where every second row goes, shape (m + 1, n).
        coarse_out: where its derivatives go, shape (2, m + 1, n).
        rough: where the greatest distance of a coordinate at each row between goes, shape (m,).
    """
    _differences(rows, inner, sided, out)
    for k in range(coarse.shape[0]):
        for j in range(rows.shape[1]):
            coarse[k, j] = rows[2 * k, j]
    _differences(coarse, inner, sided, coarse_out)
    step, per_unit = length / (rows.shape[0] - 1), (coarse.shape[0] - 1) / length
    for k in range(rough.shape[0]):
        place = (2.0 * k + 1.0) * step * per_unit
        row = min(max(int(place), 0), coarse.shape[0] - 2)
        t, most = place - row, 0.0
        for j in range(rows.shape[1]):
            start, v, a, c3, c4, c5 = _quintic(coarse, coarse_out, row, j)
            q = start + t * (v + t * (a + t * (c3 + t * (c4 + t * c5))))
            most = max(most, abs(q - rows[2 * k + 1, j]))
        rough[k] = most


@kernel("void(f8[:,::1], f8[:,::1], f8[:,::1], f8, f8[::1], f8[:,::1], f8[:,:,::1])")
def traced_points(
    rows: Array, d1: Array, d2: Array, per_unit: float, s: Array, room: Array, out: Array
) -> None:
    """Write coordinates and derivatives by the place s between rows (quintic Hermite interpolation).

    Args:
        rows: at equidistant places from 0 on, shape (k, n).
        d1: first derivatives by the number of the row, shape (k, n).
        d2: second ones.
        per_unit: rows in one unit of s.
        s: places, best in order, shape (m,).
        room: to work in, shape (COEFFICIENTS, n).
        out: where all goes, shape (3, m, n).
    """
    known, n = -1, rows.shape[1]
    for k in range(s.shape[0]):
        place = s[k] * per_unit
        row = min(max(int(place), 0), rows.shape[0] - 2)
        if row != known:
            known = row
            _between(rows, d1, d2, row, room)
        _quintics(n, place - row, per_unit, 1.0, 0.0, room, out[0, k], out[1, k], out[2, k])


@kernel("void(f8[:,::1], f8[:,::1], f8[:,::1], f8, f8[:,::1], i8, i8, f8[:,::1], i8, f8[:,:,::1])")
def traced_in_time(
    rows: Array,
    d1: Array,
    d2: Array,
    per_unit: float,
    law: Array,
    first: int,
    until: int,
    room: Array,
    at: int,
    total: Array,
) -> None:
    """Write coordinates and derivatives by time at times of a motion.

    With the place s, its speed v and acceleration a, q' = dq/ds·v and q'' = d²q/ds²·v² + dq/ds·a.

    Args:
        rows: as for `traced_points`.
        d1: see there.
        d2: see there.
        per_unit: see there.
        law: places, best in order, speeds and accelerations in its rows 1 to 3, shape (4 or more, m).
        first: number of the first time.
        until: number behind that of the last one.
        room: to work in, shape (COEFFICIENTS, n).
        at: row of the motion for the time 0 of the law.
        total: the motion, of which rows at + first to at + until are written, shape (3, m, n).
    """
    known, n = -1, rows.shape[1]
    for k in range(first, until):
        place = law[1, k] * per_unit
        row = min(max(int(place), 0), rows.shape[0] - 2)
        if row != known:
            known = row
            _between(rows, d1, d2, row, room)
        v, a = law[2, k], law[3, k]
        _quintics(n, place - row, per_unit, v, a, room, total[0, at + k], total[1, at + k], total[2, at + k])


def _between(rows: Array, d1: Array, d2: Array, row: int, room: Array) -> None:
    """Write the coefficients of the polynomials between a row and the next one."""
    after = row + 1
    _coefficients(rows.shape[1], rows[row], rows[after], d1[row], d1[after], d2[row], d2[after], room)


@columns
def _coefficients(
    count: int, start: Array, end: Array, v0: Array, v1: Array, a0: Array, a1: Array, room: Array
) -> None:
    """Write the coefficients of t⁰ to t⁵, then those of the first and of the second derivative from t¹ on."""
    for j in range(count):
        gap = end[j] - start[j]
        v = v0[j]
        w = v1[j]
        a = 0.5 * a0[j]
        b = 0.5 * a1[j]
        c3 = 10.0 * gap - 6.0 * v - 4.0 * w - 3.0 * a + b
        c4 = -15.0 * gap + 8.0 * v + 7.0 * w + 3.0 * a - 2.0 * b
        c5 = 6.0 * gap - 3.0 * (v + w) - a + b
        room[0, j] = start[j]
        room[1, j] = v
        room[2, j] = a
        room[3, j] = c3
        room[4, j] = c4
        room[5, j] = c5
        room[6, j] = 2.0 * a
        room[7, j] = 3.0 * c3
        room[8, j] = 4.0 * c4
        room[9, j] = 5.0 * c5
        room[10, j] = 6.0 * c3
        room[11, j] = 12.0 * c4
        room[12, j] = 20.0 * c5


@columns
def _quintics(
    count: int, t: float, per_unit: float, v: float, a: float, room: Array, q: Array, qd: Array, qdd: Array
) -> None:
    """Write the polynomials at t, gone through with the speed v and the acceleration a."""
    for j in range(count):
        c1 = room[1, j]
        b1 = room[6, j]
        q[j] = room[0, j] + t * (c1 + t * (room[2, j] + t * (room[3, j] + t * (room[4, j] + t * room[5, j]))))
        d1 = per_unit * (c1 + t * (b1 + t * (room[7, j] + t * (room[8, j] + t * room[9, j]))))
        d2 = per_unit * per_unit * (b1 + t * (room[10, j] + t * (room[11, j] + t * room[12, j])))
        qd[j] = d1 * v
        qdd[j] = d2 * (v * v) + d1 * a


def _differences(rows: Array, inner: Array, sided: Array, out: Array) -> None:
    count, n, sides = rows.shape[0], rows.shape[1], sided.shape[1]
    a0, a1, a2, a3, a4, a5, a6 = _seven(inner[0])
    b0, b1, b2, b3, b4, b5, b6 = _seven(inner[1])
    for k in range(HALF, count - HALF):
        for j in range(n):
            r0, r1, r2, r3 = rows[k - 3, j], rows[k - 2, j], rows[k - 1, j], rows[k, j]
            r4, r5, r6 = rows[k + 1, j], rows[k + 2, j], rows[k + 3, j]
            out[0, k, j] = a0 * r0 + a1 * r1 + a2 * r2 + a3 * r3 + a4 * r4 + a5 * r5 + a6 * r6
            out[1, k, j] = b0 * r0 + b1 * r1 + b2 * r2 + b3 * r3 + b4 * r4 + b5 * r5 + b6 * r6
    for order in range(2):
        for end in range(2 * HALF):
            k = end if end < HALF else count - 2 * HALF + end
            first = 0 if end < HALF else count - sides
            for j in range(n):
                total = 0.0
                for i in range(sides):
                    total += sided[order, k - first, i] * rows[first + i, j]
                out[order, k, j] = total


def _seven(weights: Array) -> tuple[float, float, float, float, float, float, float]:
    return weights[0], weights[1], weights[2], weights[3], weights[4], weights[5], weights[6]


def _quintic(
    rows: Array, derivatives: Array, row: int, j: int
) -> tuple[float, float, float, float, float, float]:
    """Return the coefficients of t⁰ to t⁵ between a row and the next one, t from 0 to 1."""
    start, gap = rows[row, j], rows[row + 1, j] - rows[row, j]
    v, a = derivatives[0, row, j], 0.5 * derivatives[1, row, j]
    w, b = derivatives[0, row + 1, j], 0.5 * derivatives[1, row + 1, j]
    c3 = 10.0 * gap - 6.0 * v - 4.0 * w - 3.0 * a + b
    c4 = -15.0 * gap + 8.0 * v + 7.0 * w + 3.0 * a - 2.0 * b
    c5 = 6.0 * gap - 3.0 * (v + w) - a + b
    return start, v, a, c3, c4, c5
