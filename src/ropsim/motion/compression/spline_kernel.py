"""Splines of degree five: basis functions, energy of the third derivative and polynomials of their spans.

A spline has the breakpoints b₀ < … < b_c, both ends six times as knots, and c + 5 coefficients. On span j,
from b_j to b_j+1, the basis functions j to j + 5 are not zero.
"""

from math import sqrt

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.spatial import Array

ORDER = 6
"""Basis functions that are not zero on a span."""
NODES = 3
"""Of the quadrature of Gauss and Legendre that is exact for the square of a third derivative."""


def knot(breaks: Array, spans: int, number: int) -> float:
    """Return the knot of a number from 0 to spans + 10."""
    value: float = breaks[min(max(number - 5, 0), spans)]
    return value


def span_at(breaks: Array, spans: int, u: float, span: int) -> int:
    """Return the span in which u lies, searched upwards from a span that is not behind it."""
    while span < spans - 1 and u >= breaks[span + 1]:
        span += 1
    return span


def basis(breaks: Array, spans: int, span: int, u: float, degree: int, values: Array) -> None:
    """Write the degree + 1 basis functions of this degree that are not zero on a span.

    By the recursion of Cox and de Boor (Piegl and Tiller 1997, The NURBS Book, algorithm A2.2).

    Args:
        breaks: breakpoints, shape (spans + 1,) or longer.
        spans: their number less one.
        span: in which u lies.
        u: path parameter.
        degree: at most 5.
        values: becomes their values, shape (6,).
    """
    values[0] = 1.0
    for p in range(1, degree + 1):
        carried = 0.0
        for r in range(p):
            right = knot(breaks, spans, span + 6 + r) - u
            left = u - knot(breaks, spans, span + 6 - p + r)
            share = values[r] / (right + left)
            values[r] = carried + right * share
            carried = left * share
        values[p] = carried


def basis_rows(breaks: Array, spans: int, parameters: Array, values: Array, firsts: Array) -> None:
    """Write the six basis functions at rising parameters (m,), shape (m, 6), and the spans there, (m,)."""
    span = 0
    for i in range(parameters.shape[0]):
        span = span_at(breaks, spans, parameters[i], span)
        firsts[i] = span
        basis(breaks, spans, span, parameters[i], 5, values[i])


def third_derivative_rows(breaks: Array, spans: int, rule: Array, work: Array, thirds: Array) -> None:
    """Write the third derivatives of the basis functions at the nodes of every span.

    Args:
        breaks: breakpoints, shape (spans + 1,) or longer.
        spans: their number less one.
        rule: points in [0, 1] and weights of the quadrature, shape (2, NODES).
        work: shape (7, 6) or more.
        thirds: becomes the derivatives, each times the root of the weight of the node, shape (spans, 18) or
            longer.
    """
    for span in range(spans):
        for i in range(ORDER):
            for k in range(ORDER):
                work[i, k] = 1.0 if i == k else 0.0
        for order in range(1, 4):
            for i in range(ORDER - order):
                wide = knot(breaks, spans, span + i + 6) - knot(breaks, spans, span + i + order)
                share = (ORDER - order) / wide
                for k in range(ORDER):
                    work[i, k] = (work[i + 1, k] - work[i, k]) * share
        length = breaks[span + 1] - breaks[span]
        for node in range(NODES):
            basis(breaks, spans, span, breaks[span] + rule[0, node] * length, 2, work[6])
            root = sqrt(rule[1, node] * length)
            for k in range(ORDER):
                value = work[6, 0] * work[0, k] + work[6, 1] * work[1, k] + work[6, 2] * work[2, k]
                thirds[span, ORDER * node + k] = value * root


def add_energy(thirds: Array, spans: int, matrix: Array) -> None:
    """Add the integrals of products of third derivatives to a matrix of normal equations."""
    for span in range(spans):
        for node in range(NODES):
            first = ORDER * node
            for i in range(ORDER):
                for k in range(i + 1):
                    matrix[span + i, i - k] += thirds[span, first + i] * thirds[span, first + k]


def energy(thirds: Array, spans: int, coefficients: Array, column: int, count: int) -> float:
    """Return the integral of the square of the third derivative, of columns from `column` on."""
    total = 0.0
    for span in range(spans):
        for node in range(NODES):
            for j in range(column, column + count):
                value = 0.0
                for i in range(ORDER):
                    value += thirds[span, ORDER * node + i] * coefficients[span + i, j]
                total += value * value
    return total


@kernel
def span_polynomials(
    breaks: Array1, spans: int, coefficients: Array2, work: Array2, polynomials: Array3
) -> None:
    """Write the polynomials of every span over its share, from 0 to 1.

    Args:
        breaks: breakpoints, shape (spans + 1,) or longer.
        spans: their number less one.
        coefficients: of the spline, shape (spans + 5, n) or longer.
        work: shape (7, n), n at least 6.
        polynomials: becomes the coefficients of the powers 0 to 5, shape (spans, 6, n) or longer.
    """
    for span in range(spans):
        length, factor = breaks[span + 1] - breaks[span], 1.0
        for i in range(ORDER):
            for k in range(coefficients.shape[1]):
                work[i, k] = coefficients[span + i, k]
        for order in range(ORDER):
            if order > 0:
                factor *= length / order
                for i in range(ORDER - order):
                    wide = knot(breaks, spans, span + i + 6) - knot(breaks, spans, span + i + order)
                    share = (ORDER - order) / wide
                    for k in range(coefficients.shape[1]):
                        work[i, k] = (work[i + 1, k] - work[i, k]) * share
            basis(breaks, spans, span, breaks[span], 5 - order, work[6])
            for k in range(coefficients.shape[1]):
                total = 0.0
                for i in range(ORDER - order):
                    total += work[6, i] * work[i, k]
                polynomials[span, order, k] = total * factor
