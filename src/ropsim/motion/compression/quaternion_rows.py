"""Rows of quaternions: even turns between two, and the angular velocity of curves of quaternions."""

import math

import numpy as np

from ropsim.spatial import Array, cross

_STILL = 1e-9
"""Sine of half an angle between orientations, below which they are mixed linearly."""
_CONJUGATE = np.array([1.0, -1.0, -1.0, -1.0])


def between(one: Array, two: Array, shares: Array) -> Array:
    """Return the unit quaternions at shares of the even turns from one to another, (m, 4) and (m,)."""
    angles = np.arccos(np.clip(np.einsum("ij,ij->i", one, two), -1.0, 1.0))
    sines = np.sin(angles)
    still = sines < _STILL
    safe = np.where(still, 1.0, sines)
    first = np.where(still, 1.0 - shares, np.sin((1.0 - shares) * angles) / safe)
    second = np.where(still, shares, np.sin(shares * angles) / safe)
    mixed = first[:, None] * one + second[:, None] * two
    return np.asarray(mixed / np.sqrt(np.einsum("ij,ij->i", mixed, mixed))[:, None])


def rate_between(one: Array, other: Array) -> Array:
    """Return the derivative at a unit quaternion of the even turn to another one, over its share, (4,)."""
    angle = math.acos(min(max(float(one @ other), -1.0), 1.0))
    sine = math.sin(angle)
    return np.asarray(other - one if sine < _STILL else (other - one * math.cos(angle)) * (angle / sine))


def turn_at(q: Array, d1: Array, d2: Array) -> tuple[Array, Array, Array]:
    """Return rotations, angular velocities and their derivatives from quaternions and derivatives, (m, 4).

    With s = q'·q⁻¹ the angular velocity in the fixed frame is twice the vector of s, and its derivative twice
    the vector of q''·q⁻¹ - s². The length of q, which may change, has no influence.
    """
    square = np.einsum("ij,ij->i", q, q)[:, None]
    inverse = q * _CONJUGATE / square
    s = _product(d1, inverse)
    change = _product(d2, inverse)[:, 1:] - 2.0 * s[:, :1] * s[:, 1:]
    return _rotations(q / np.sqrt(square)), 2.0 * s[:, 1:], 2.0 * change


def _product(a: Array, b: Array) -> Array:
    """Return products of quaternions, (m, 4)."""
    product = np.empty(a.shape)
    product[:, 0] = a[:, 0] * b[:, 0] - np.einsum("ij,ij->i", a[:, 1:], b[:, 1:])
    product[:, 1:] = a[:, :1] * b[:, 1:] + b[:, :1] * a[:, 1:] + cross(a[:, 1:], b[:, 1:])
    return product


def _rotations(q: Array) -> Array:
    """Return the rotations of unit quaternions (m, 4), shape (m, 3, 3)."""
    w, x, y, z = q.T
    rotations = np.empty((len(q), 3, 3))
    rotations[:, 0, 0] = 1.0 - 2.0 * (y * y + z * z)
    rotations[:, 0, 1] = 2.0 * (x * y - w * z)
    rotations[:, 0, 2] = 2.0 * (x * z + w * y)
    rotations[:, 1, 0] = 2.0 * (x * y + w * z)
    rotations[:, 1, 1] = 1.0 - 2.0 * (x * x + z * z)
    rotations[:, 1, 2] = 2.0 * (y * z - w * x)
    rotations[:, 2, 0] = 2.0 * (x * z - w * y)
    rotations[:, 2, 1] = 2.0 * (y * z + w * x)
    rotations[:, 2, 2] = 1.0 - 2.0 * (x * x + y * y)
    return rotations
