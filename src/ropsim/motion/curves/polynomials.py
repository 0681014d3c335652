"""Polynomials of degree five: between two ends with their derivatives, and evaluated with them."""

import numpy as np

from ropsim.spatial import Array, frozen

# rows: coefficients of t⁰ to t⁵; columns: value, first and second derivative at 0, then at 1
_FROM_ENDS = frozen(
    [
        [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.5, 0.0, 0.0, 0.0],
        [-10.0, -6.0, -1.5, 10.0, -4.0, 0.5],
        [15.0, 8.0, 1.5, -15.0, 7.0, -1.0],
        [-6.0, -3.0, -0.5, 6.0, -3.0, 0.5],
    ]
)


def quintics(ends: Array) -> Array:
    """Return the coefficients of the polynomials between pairs of ends (quintic Hermite interpolation).

    Args:
        ends: value, first and second derivative at t = 0, then at t = 1, shape (..., 6, n).

    Returns:
        coefficients of t⁰ to t⁵, shape (..., 6, n).
    """
    return np.asarray(_FROM_ENDS @ ends)


def with_derivatives(coefficients: Array) -> Array:
    """Return coefficients (..., 6, n) with those of the first and second derivative, (..., 6, 3·n)."""
    *shape, n = coefficients.shape
    result = np.zeros((*shape, 3 * n))
    result[..., :n] = coefficients
    for order in (1, 2):
        before = result[..., 1:, (order - 1) * n : order * n]
        result[..., :-1, order * n : (order + 1) * n] = before * _EXPONENTS
    return result


def largest(coefficients: Array) -> float:
    """Return the greatest length of vectors that are polynomials of t from 0 to 1, sampled at 65 points.

    Args:
        coefficients: of t⁰ to t⁵, shape (..., 6, n).
    """
    return float(np.linalg.norm(_SAMPLES @ coefficients, axis=-1).max())


def powers(t: Array) -> Array:
    """Return t⁰ to t⁵ of shape (k,), shape (k, 6)."""
    result = np.empty((len(t), 6))
    result[:, 0] = 1.0
    for k in range(1, 6):
        np.multiply(result[:, k - 1], t, out=result[:, k])
    return result


_EXPONENTS = frozen([[1.0], [2.0], [3.0], [4.0], [5.0]])


_SAMPLES = frozen(powers(np.linspace(0.0, 1.0, 65)))
