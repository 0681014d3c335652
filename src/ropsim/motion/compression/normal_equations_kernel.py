"""Least squares with a spline: normal equations with five side diagonals, their factor and their solution.

A symmetric matrix is stored by rows: element (i, i - k) in row i and column k, k from 0 to 5.
"""

from math import sqrt

from ropsim.spatial import Array

ORDER = 6
LEAST = 1e-15
"""Of a diagonal element: the least pivot."""


def add_samples(basis: Array, spans: Array, weights: Array, matrix: Array) -> None:
    """Add the weighted products of the basis functions at all samples to a matrix.

    Args:
        basis: functions at the samples, shape (m, 6).
        spans: numbers of the first of them, shape (m,).
        weights: of the samples, shape (m,).
        matrix: shape (count, 6).
    """
    for i in range(basis.shape[0]):
        first = int(spans[i])
        for p in range(ORDER):
            x = weights[i] * basis[i, p]
            for q in range(p + 1):
                matrix[first + p, p - q] += x * basis[i, q]


def add_values(
    basis: Array, spans: Array, weights: Array, values: Array, right: Array, column: int, count: int
) -> None:
    """Add the weighted samples to the right sides.

    Args:
        basis: functions at the samples, shape (m, 6).
        spans: numbers of the first of them, shape (m,).
        weights: of the samples, shape (m,).
        values: of the samples, the columns from `column` on, `count` of them, shape (m, n).
        right: the same columns, shape (coefficients, n).
        column: first column.
        count: number of columns.
    """
    for i in range(basis.shape[0]):
        first = int(spans[i])
        for p in range(ORDER):
            x = weights[i] * basis[i, p]
            for j in range(column, column + count):
                right[first + p, j] += x * values[i, j]


def move_given(matrix: Array, begin: int, end: int, size: int, right: Array, given: Array) -> None:
    """Subtract the products with given unknowns, before `begin` and from `end` on, from right sides.

    Args:
        matrix: shape (size, 6) or longer.
        begin: number of the first free unknown.
        end: number behind the last free one.
        size: number of unknowns.
        right: right sides, shape (size, n) or longer.
        given: the unknowns, given ones filled in, shape (size, n) or longer.
    """
    for i in range(begin, end):
        for k in range(1, ORDER):
            if i - k >= 0 and i - k < begin:
                for j in range(right.shape[1]):
                    right[i, j] -= matrix[i, k] * given[i - k, j]
            if i + k < size and i + k >= end:
                for j in range(right.shape[1]):
                    right[i, j] -= matrix[i + k, k] * given[i + k, j]


def factorize(matrix: Array, begin: int, end: int) -> None:
    """Replace rows of a positive definite matrix by the rows of its Cholesky factor, the diagonal inverted.

    Args:
        matrix: shape (size, 6) or longer.
        begin: first row.
        end: behind the last row; other rows and columns are not changed.
    """
    for i in range(begin, end):
        for k in range(min(ORDER - 1, i - begin), -1, -1):
            j = i - k
            total = matrix[i, k]
            for c in range(max(begin, i - ORDER + 1), j):
                total -= matrix[i, i - c] * matrix[j, j - c]
            if k > 0:
                matrix[i, k] = total * matrix[j, 0]
            else:
                matrix[i, 0] = 1.0 / sqrt(max(total, LEAST * matrix[i, 0]))


def substitute(factor: Array, begin: int, end: int, right: Array, column: int, count: int) -> None:
    """Replace right sides by the solutions, for rows begin .. end - 1 and columns from `column` on."""
    for i in range(begin, end):
        for k in range(1, min(ORDER - 1, i - begin) + 1):
            for j in range(column, column + count):
                right[i, j] -= factor[i, k] * right[i - k, j]
        for j in range(column, column + count):
            right[i, j] *= factor[i, 0]
    for i in range(end - 1, begin - 1, -1):
        for k in range(1, min(ORDER - 1, end - 1 - i) + 1):
            for j in range(column, column + count):
                right[i, j] -= factor[i + k, k] * right[i + k, j]
        for j in range(column, column + count):
            right[i, j] *= factor[i, 0]
