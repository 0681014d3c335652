"""Rotation vectors: orientation, angular velocity and angular acceleration as functions of three numbers.

A rotation vector θ is axis times angle; K is the matrix of its cross product, x = |θ|². All coefficients are
power series in x, so nothing needs a case of its own near no turn at all; they are exact to rounding up to a
full turn. The loops over rows are in `curve_kernel`.
"""

import math
from functools import cache

import numpy as np

from ropsim.motion.curves.curve_kernel import rate_rows, turning_rows
from ropsim.spatial import Array, frozen, quaternions_from_matrices

FULL_TURN = 2.0 * math.pi
"""Rotation vectors up to this length are distinguished exactly [rad]."""
_TERMS = 18  # (2π)²ᵏ / (2k + 1)! is below the last bits from there on


def exponentials(vectors: Array) -> Array:
    """Return the rotations exp(K) = I + c₁·K + c₂·K² of rotation vectors (k, 3) [rad], shape (k, 3, 3)."""
    return turning(vectors, np.zeros(vectors.shape), np.zeros(vectors.shape))[0]


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
    count = len(vectors)
    rotations, speed, change = np.empty((count, 3, 3)), np.empty((count, 3)), np.empty((count, 3))
    v, rate, bend = (np.ascontiguousarray(rows) for rows in (vectors, d1, d2))
    turning_rows(series(), v, rate, bend, rotations, speed, change)
    return rotations, speed, change


def rates(vectors: Array, speed: Array, change: Array) -> tuple[Array, Array]:
    """Return θ' and θ'' from angular velocity and its derivative: the inverse of `turning`.

    Args:
        vectors: θ [rad], shape (k, 3), of less than a full turn.
        speed: ω in the fixed frame, shape (k, 3).
        change: its derivative, shape (k, 3).
    """
    d1, d2 = np.empty((len(vectors), 3)), np.empty((len(vectors), 3))
    v, w, grown = (np.ascontiguousarray(rows) for rows in (vectors, speed, change))
    rate_rows(series(), v, w, grown, d1, d2)
    return d1, d2


@cache
def series() -> Array:
    """Return the coefficients of xᵏ in the functions of `curve_kernel`, shape (6, terms)."""
    c = np.array([[(-1.0) ** k / math.factorial(2 * k + j) for k in range(_TERMS + 1)] for j in (1, 2, 3)])
    by_x = c[1:, 1:] * np.arange(1, _TERMS + 1)
    return frozen(np.concatenate((c[:, :-1], by_x, [c[1, 1:] - 0.5 * c[0, 1:]])))
