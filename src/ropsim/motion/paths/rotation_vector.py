"""Rotation vectors: orientation, angular velocity and angular acceleration as functions of three numbers.

A rotation vector θ is axis times angle; K is the matrix of its cross product, x = |θ|². All coefficients are
power series in x, so nothing needs a case of its own near no turn at all. They are exact to rounding up to a
full turn.
"""

import math
from functools import cache

import numpy as np

from ropsim.spatial import Array, frozen, quaternions_from_matrices

_TERMS = 18  # (2π)²ᵏ / (2k + 1)! is below the last bits from there on


def exponentials(vectors: Array) -> Array:
    """Return the rotations exp(K) = I + c₁·K + c₂·K² of rotation vectors (k, 3) [rad], shape (k, 3, 3)."""
    c, K = _coefficients(vectors), _crosses(vectors)
    return _sums(K, K @ K, c[0], c[1])


def logarithms(rotations: Array) -> Array:
    """Return the rotation vectors, of at most half a turn, of rotations (k, 3, 3), shape (k, 3) [rad]."""
    q = quaternions_from_matrices(rotations)
    sines = np.sqrt(np.sum(q[:, 1:] * q[:, 1:], axis=1))
    angles = 2.0 * np.arctan2(sines, q[:, 0])
    ratios = np.divide(angles, sines, out=np.full(len(q), 2.0), where=sines > 0.0)
    return np.asarray(ratios[:, None] * q[:, 1:])


def turning(vectors: Array, d1: Array, d2: Array) -> tuple[Array, Array, Array]:
    """Return exp(K), its angular velocity ω and the derivative of that, in the fixed frame.

    ω = θ' + c₂·θ×θ' + c₃·θ×(θ×θ'), with c₂ = (1 - cos|θ|) / |θ|² and c₃ = (|θ| - sin|θ|) / |θ|³; both are
    sums of θ, θ', θ'', θ×θ' and θ×θ''.

    Args:
        vectors: θ [rad], shape (k, 3).
        d1: θ', shape (k, 3).
        d2: θ'', shape (k, 3).

    Returns:
        rotations (k, 3, 3), ω (k, 3) and ω' (k, 3).

    References:
        Iserles, Munthe-Kaas, Nørsett and Zanna 2000, Lie-group methods, Acta Numerica 9, section 2.6 (the
        series of dexp).
    """
    c1, c2, c3, c2_x, c3_x = _coefficients(vectors)
    K = _crosses(vectors)
    summands = np.empty((len(vectors), 5, 3))
    summands[:, 0], summands[:, 1], summands[:, 2] = vectors, d1, d2
    products = summands[:, :3] @ summands[:, :3].transpose(0, 2, 1)
    summands[:, 3:] = summands[:, 1:3] @ K.transpose(0, 2, 1)
    x, along = products[:, 0, 0], products[:, 0, 1]
    bent = (2.0 * along) * c3_x
    weights = np.zeros((len(vectors), 2, 5))
    weights[:, 0, 0] = c3 * along
    weights[:, 0, 1] = weights[:, 1, 2] = c1  # as 1 - c₃·x
    weights[:, 0, 3] = weights[:, 1, 4] = c2
    weights[:, 1, 0] = c3 * (products[:, 0, 2] + products[:, 1, 1]) + bent * along
    weights[:, 1, 1] = -c3 * along - bent * x
    weights[:, 1, 3] = (2.0 * along) * c2_x
    motion = weights @ summands
    return _sums(K, K @ K, c1, c2), motion[:, 0], motion[:, 1]


def rates(vectors: Array, speed: Array, change: Array) -> tuple[Array, Array]:
    """Return θ' and θ'' from angular velocity and its derivative: the inverse of `turning`.

    Args:
        vectors: θ [rad], shape (k, 3), of less than a full turn.
        speed: ω in the fixed frame, shape (k, 3).
        change: its derivative, shape (k, 3).
    """
    c, K = _coefficients(vectors), _crosses(vectors)
    left = _sums(K, K @ K, c[1], c[2])  # ω = left·θ'
    d1 = np.asarray(np.linalg.solve(left, speed[:, :, None])[:, :, 0], np.float64)
    _, _, rest = turning(vectors, d1, np.zeros(d1.shape))
    d2 = np.linalg.solve(left, (change - rest)[:, :, None])[:, :, 0]
    return d1, np.asarray(d2, np.float64)


def _crosses(vectors: Array) -> Array:
    """Return the matrices of the cross products of vectors (k, 3), shape (k, 3, 3)."""
    return (vectors @ _CROSS).reshape(-1, 3, 3)


def _sums(K: Array, KK: Array, first: Array, second: Array) -> Array:
    """Return I + first·K + second·K² for rows of K, shape (k, 3, 3)."""
    result = first[:, None, None] * K
    result += second[:, None, None] * KK
    result += _IDENTITY
    return result


def _coefficients(vectors: Array) -> Array:
    """Return c₁ = sin|θ| / |θ|, c₂, c₃ and the derivatives of c₂ and c₃ by x, for (k, 3), shape (5, k)."""
    powers = np.empty((_TERMS, len(vectors)))
    powers[0] = 1.0
    powers[1:] = np.einsum("ki,ki->k", vectors, vectors)
    np.multiply.accumulate(powers, axis=0, out=powers)
    return np.asarray(_series() @ powers)


@cache
def _series() -> Array:
    """Return the coefficients of xᵏ in the five functions, shape (5, terms)."""
    c = np.array([[(-1.0) ** k / math.factorial(2 * k + j) for k in range(_TERMS + 1)] for j in (1, 2, 3)])
    return frozen(np.concatenate((c[:, :-1], c[1:, 1:] * np.arange(1, _TERMS + 1))))


_IDENTITY = frozen(np.eye(3))
_CROSS = frozen(  # rows: which entries of K the three components are
    [
        [0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    ]
)
