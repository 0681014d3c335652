"""Traced paths in plain loops that numba compiles: derivatives at the rows, and how rough these are."""

from ropsim.codegen import kernel
from ropsim.spatial import Array

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
