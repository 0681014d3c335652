"""Derivatives by differences: of rows at equidistant path parameters, and of poses without derivatives."""

import math
from collections.abc import Callable
from functools import cache

import numpy as np

from ropsim.motion.curves.differences_kernel import row_differences, rows_with_error
from ropsim.motion.curves.path import ToolPoints
from ropsim.motion.curves.rotation_vector import logarithms
from ropsim.spatial import Array, frozen

_CENTRAL = 7
_SIDED = 8  # one row more, for second derivatives of the same order at the ends
_FINENESS = 256  # steps on the length of a path; rounding and the order of the differences are even there


def row_derivatives(rows: Array, step: float) -> Array:
    """Return first and second derivatives of rows at equidistant path parameters.

    Central differences of order 6, one-sided ones of the same order at the three rows of each end; k < 9
    rows are differentiated as the polynomial through all of them.

    Args:
        rows: shape (k, n), k >= 2.
        step: from one path parameter to the next.

    Returns:
        first and second derivatives, shape (2, k, n).

    References:
        Fornberg 1988, Generation of Finite Difference Formulas on Arbitrarily Spaced Grids, Mathematics of
        Computation 51(184), 699-706.
    """
    count = len(rows)
    result = np.empty((2, *rows.shape))
    if count <= _SIDED:
        result[:] = _weights(count) @ rows
    else:
        inner, sided = stencils()
        row_differences(np.ascontiguousarray(rows), inner, sided, result)
    result[0] *= 1.0 / step
    result[1] *= 1.0 / step**2
    return result


def derivatives_and_roughness(rows: Array) -> tuple[Array, Array | None]:
    """Return first and second derivatives of rows by their number, and how rough the path through them is.

    Args:
        rows: at equidistant path parameters, shape (k, n), k >= 2, without gaps.

    Returns:
        the derivatives, shape (2, k, n), and how far the path through every second of 2·m + 1 rows passes the
        others [rad | m], shape (m,). None for the latter where the rows are too few or of even number.
    """
    count, n = rows.shape
    half = count // 2 + 1
    if count % 2 == 0 or half <= _SIDED:
        return row_derivatives(rows, 1.0), None
    out, coarse, error = np.empty((2, count, n)), np.empty((3, half, n)), np.empty(half - 1)
    rows_with_error(rows, *stencils(), out, coarse[0], coarse[1:], error)
    return out, error


def numeric_points(matrices_at: Callable[[Array], Array], s: Array, length: float) -> ToolPoints:
    """Return the tool and its derivatives at path parameters of a path that has poses only.

    Differences of order 6 over 1/256 of the length, one-sided near the ends; the path is not evaluated
    outside its length. Turns between neighbours are rotation vectors from the pose at s, whose second
    derivative there is that of the angular velocity.

    Args:
        matrices_at: poses at path parameters, shape (k,) to (k, 4, 4); six times smooth.
        s: path parameters, shape (k,), in [0, length].
        length: of the path.
    """
    step = length / _FINENESS
    half = _CENTRAL // 2
    centres = np.clip(s, half * step, length - half * step)
    offsets = (s - centres) / step
    nodes = centres[:, None] + step * np.arange(-half, half + 1)
    stencil = matrices_at(np.clip(nodes, 0.0, length).ravel()).reshape(len(s), _CENTRAL, 4, 4)
    weights = np.stack([_weights_at(offsets, _CENTRAL, order) for order in (1, 2)], axis=1)  # (k, 2, 7)
    return _points(matrices_at(s), stencil, weights, np.full(len(s), step))


def pose_derivatives(matrices_at: Callable[[Array], Array], steps: Array) -> ToolPoints:
    """Return poses that are functions of an offset each, with their derivatives by it where it is 0.

    Central differences of order 6, otherwise as `numeric_points`.

    Args:
        matrices_at: poses at offsets, shape (k, 7) to (k, 7, 4, 4); the functions are six times smooth.
        steps: from one offset to the next, shape (k,); over one the pose changes by a few hundredths.
    """
    half = _CENTRAL // 2
    stencil = matrices_at(steps[:, None] * np.arange(-half, half + 1))
    return _points(stencil[:, half], stencil, stencils()[0], steps)


def _points(matrices: Array, stencil: Array, weights: Array, steps: Array) -> ToolPoints:
    """Return poses (k, 4, 4) with the derivatives that poses around them (k, 7, 4, 4) have by weights."""
    count = len(matrices)
    turned = np.swapaxes(matrices[:, None, :3, :3], 2, 3) @ stencil[..., :3, :3]
    coordinates = np.empty((count, _CENTRAL, 6))
    coordinates[..., :3] = stencil[..., :3, 3] - matrices[:, None, :3, 3]
    coordinates[..., 3:] = logarithms(turned.reshape(-1, 3, 3)).reshape(count, _CENTRAL, 3)
    rows = weights @ coordinates
    rows[..., 3:] = rows[..., 3:] @ np.swapaxes(matrices[:, :3, :3], 1, 2)
    by_step = 1.0 / steps[:, None]
    return ToolPoints(matrices, rows[:, 0] * by_step, rows[:, 1] * by_step**2)


@cache
def _weights(count: int) -> Array:
    """Return the weights of first and second derivatives at each of `count` rows, shape (2, count, count)."""
    return frozen([_weights_at(_offsets(count), count, order) for order in (1, 2)])


@cache
def stencils() -> tuple[Array, Array]:
    """Return the weights around a row, shape (2, 7), and at the ends, shape (2, 8, 8)."""
    return frozen(_weights(_CENTRAL)[:, _CENTRAL // 2]), _weights(_SIDED)


def _weights_at(offsets: Array, count: int, order: int) -> Array:
    """Return weights of rows in a derivative at offsets from their middle [steps], shape (k, count)."""
    exponents = np.arange(order, count)
    factors = [math.perm(int(exponent), order) for exponent in exponents]
    return np.asarray((offsets[:, None] ** (exponents - order) * factors) @ _lagrange(count)[order:])


@cache
def _lagrange(count: int) -> Array:
    """Return the polynomials that are 1 at one row and 0 at the others, powers by rows, (count, count)."""
    offsets = _offsets(count)
    others = [np.delete(offsets, row) for row in range(count)]
    return frozen(
        np.stack([np.poly(o)[::-1] / np.prod(x - o) for x, o in zip(offsets, others, strict=True)], axis=1)
    )


def _offsets(count: int) -> Array:
    return np.arange(count, dtype=np.float64) - (count - 1) / 2.0
