"""Rotation vectors: orientation, angular velocity and angular acceleration as functions of three numbers.

A rotation vector θ is axis times angle; K is the matrix of its cross product, x = |θ|². All coefficients are
power series in x, so nothing needs a case of its own near no turn at all. They are exact to rounding up to a
full turn.
"""

import math
from functools import cache

import numpy as np

from ropsim.spatial import Array, frozen, quaternions_from_matrices

_TERMS = 22  # (2π)²ᵏ / (2k + 1)! is below the last bit from there on


def exponentials(vectors: Array) -> Array:
    """Return the rotations exp(K) = I + c₁·K + c₂·K² of rotation vectors (k, 3) [rad], shape (k, 3, 3)."""
    coefficients = _coefficients(vectors)
    return _sums(vectors, coefficients[:, 0], coefficients[:, 1])


def logarithms(rotations: Array) -> Array:
    """Return the rotation vectors, of at most half a turn, of rotations (k, 3, 3), shape (k, 3) [rad]."""
    q = quaternions_from_matrices(rotations)
    sines = np.sqrt(np.sum(q[:, 1:] * q[:, 1:], axis=1))
    angles = 2.0 * np.arctan2(sines, q[:, 0])
    ratios = np.divide(angles, sines, out=np.full(len(q), 2.0), where=sines > 0.0)
    return np.asarray(ratios[:, None] * q[:, 1:])


def velocities(vectors: Array, d1: Array, d2: Array) -> tuple[Array, Array]:
    """Return angular velocity ω and its derivative of exp(K) from the derivatives of θ, in the fixed frame.

    ω = θ' + c₂·θ×θ' + c₃·θ×(θ×θ'), with c₂ = (1 - cos|θ|) / |θ|² and c₃ = (|θ| - sin|θ|) / |θ|³.

    Args:
        vectors: θ [rad], shape (k, 3).
        d1: θ', shape (k, 3).
        d2: θ'', shape (k, 3).

    References:
        Iserles, Munthe-Kaas, Nørsett and Zanna 2000, Lie-group methods, Acta Numerica 9, section 2.6 (the
        series of dexp).
    """
    c = _coefficients(vectors)
    c2, c3, c2_x, c3_x = (c[:, k, None] for k in range(1, 5))
    x_rate = 2.0 * np.sum(vectors * d1, axis=1, keepdims=True)
    turned = cross(vectors, d1)
    twice = cross(vectors, turned)
    speed = d1 + c2 * turned + c3 * twice
    bent = cross(vectors, d2)
    change = (
        d2
        + c2_x * x_rate * turned
        + c2 * bent
        + c3_x * x_rate * twice
        + c3 * (cross(d1, turned) + cross(vectors, bent))
    )
    return speed, change


def rates(vectors: Array, speed: Array, change: Array) -> tuple[Array, Array]:
    """Return θ' and θ'' from angular velocity and its derivative: the inverse of `velocities`.

    Args:
        vectors: θ [rad], shape (k, 3), of less than a full turn.
        speed: ω in the fixed frame, shape (k, 3).
        change: its derivative, shape (k, 3).
    """
    c = _coefficients(vectors)
    left = _sums(vectors, c[:, 1], c[:, 2])
    d1 = np.asarray(np.linalg.solve(left, speed[:, :, None])[:, :, 0], np.float64)
    _, rest = velocities(vectors, d1, np.zeros(d1.shape))
    d2 = np.linalg.solve(left, (change - rest)[:, :, None])[:, :, 0]
    return d1, np.asarray(d2, np.float64)


def cross(a: Array, b: Array) -> Array:
    """Return a × b of rows, shapes (k, 3)."""
    return a[:, _NEXT] * b[:, _LAST] - a[:, _LAST] * b[:, _NEXT]


def _sums(vectors: Array, first: Array, second: Array) -> Array:
    """Return I + first·K + second·K² for rows of rotation vectors, shape (k, 3, 3)."""
    # K² = θ·θᵀ - x·I
    result = second[:, None, None] * vectors[:, :, None] * vectors[:, None, :]
    bare = 1.0 - second * np.sum(vectors * vectors, axis=1)
    turned = first[:, None] * vectors
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        result[:, i, i] += bare
        result[:, k, j] += turned[:, i]
        result[:, j, k] -= turned[:, i]
    return np.asarray(result)


def _coefficients(vectors: Array) -> Array:
    """Return c₁ = sin|θ| / |θ|, c₂, c₃ and the derivatives of c₂ and c₃ by x, shape (k, 5)."""
    x = np.sum(vectors * vectors, axis=1)
    powers = np.empty((len(x), _TERMS))
    powers[:, 0] = 1.0
    for k in range(1, _TERMS):
        np.multiply(powers[:, k - 1], x, out=powers[:, k])
    return np.asarray(powers @ _series())


@cache
def _series() -> Array:
    """Return the coefficients of xᵏ in the five functions, shape (terms, 5)."""
    signs = [(-1.0) ** k for k in range(_TERMS + 1)]
    c = np.array([[sign / math.factorial(2 * k + j) for j in (1, 2, 3)] for k, sign in enumerate(signs)])
    by_x = np.arange(1, _TERMS + 1)[:, None] * c[1:, 1:]
    return frozen(np.concatenate((c[:-1], by_x), axis=1))


_NEXT = [1, 2, 0]
_LAST = [2, 0, 1]
