"""Traced paths in plain loops that numba compiles: derivatives at the rows, and how rough these are."""

from ropsim.codegen import Array1, Array2, Array3, columns, kernel
from ropsim.spatial import Array

HALF = 3
"""So many rows on either side weigh in the derivatives of one; those at the ends have others."""
SIDED = 8
"""So many rows weigh in these."""


@kernel
def row_differences(rows: Array2, inner: Array2, sided: Array3, out: Array3) -> None:
    """Write the first and second derivative of every row, by the number of the row.

    Args:
        rows: at equidistant path parameters, shape (k, n).
        inner: weights of the seven rows around a row, shape (2, 7).
        sided: weights of the first rows at each of them, shape (2, SIDED, SIDED); the last have them, too.
        out: where the derivatives go, shape (2, k, n).
    """
    _differences(rows, inner, sided, out)


@kernel
def rows_with_error(
    rows: Array2,
    inner: Array2,
    sided: Array3,
    out: Array3,
    coarse: Array2,
    coarse_out: Array3,
    error: Array1,
) -> None:
    """Write the derivatives of every row, and how far the path through every second row passes the others.

    Midway from one row to the next a quintic is the mean of both rows with 5/32 of the difference of their
    first derivatives and 1/64 of the sum of the second ones.

    Args:
        rows: at equidistant path parameters, shape (2·m + 1, n).
        inner: weights as for `row_differences`.
        sided: of the same shape; m + 1 is no less than SIDED.
        out: where the derivatives go, shape (2, 2·m + 1, n).
        coarse: where every second row goes, shape (m + 1, n).
        coarse_out: where its derivatives go, shape (2, m + 1, n).
        error: where the greatest distance of a coordinate at each row between goes, shape (m,).
    """
    _differences(rows, inner, sided, out)
    for k in range(coarse.shape[0]):
        for j in range(rows.shape[1]):
            coarse[k, j] = rows[2 * k, j]
    _differences(coarse, inner, sided, coarse_out)
    v, a = coarse_out[0], coarse_out[1]
    for k in range(error.shape[0]):
        most = 0.0
        for j in range(rows.shape[1]):
            mean, bend = 0.5 * (coarse[k, j] + coarse[k + 1, j]), a[k, j] + a[k + 1, j]
            q = mean + (0.15625 * (v[k, j] - v[k + 1, j]) + 0.015625 * bend)
            most = max(most, abs(q - rows[2 * k + 1, j]))
        error[k] = most


def _differences(rows: Array, inner: Array, sided: Array, out: Array) -> None:
    count, n = rows.shape
    for k in range(HALF, count - HALF):
        _central(n, inner[0], inner[1], rows[k - HALF : k + HALF + 1], out[0, k], out[1, k])
    for order in range(2):
        for end in range(2 * HALF):
            k = end if end < HALF else count - 2 * HALF + end
            begin = 0 if end < HALF else count - SIDED
            _one_sided(n, sided[order, k - begin], rows[begin : begin + SIDED], out[order, k])


@columns
def _central(count: int, one: Array, two: Array, rows: Array, first: Array, second: Array) -> None:
    """Write first and second differences of a row from the seven rows around it."""
    for j in range(count):
        a = one[0] * rows[0, j] + one[1] * rows[1, j] + one[2] * rows[2, j] + one[3] * rows[3, j]
        first[j] = a + one[4] * rows[4, j] + one[5] * rows[5, j] + one[6] * rows[6, j]
        b = two[0] * rows[0, j] + two[1] * rows[1, j] + two[2] * rows[2, j] + two[3] * rows[3, j]
        second[j] = b + two[4] * rows[4, j] + two[5] * rows[5, j] + two[6] * rows[6, j]


@columns
def _one_sided(count: int, weights: Array, rows: Array, out: Array) -> None:
    """Write differences from eight rows."""
    for j in range(count):
        total = weights[0] * rows[0, j] + weights[1] * rows[1, j] + weights[2] * rows[2, j]
        total = total + weights[3] * rows[3, j] + weights[4] * rows[4, j] + weights[5] * rows[5, j]
        out[j] = total + weights[6] * rows[6, j] + weights[7] * rows[7, j]
