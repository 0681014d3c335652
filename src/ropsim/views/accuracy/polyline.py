"""Nearest places on a polyline through recorded positions."""

import numpy as np

from ropsim.spatial import Array


def nearest(corners: Array, points: Array) -> tuple[Array, Array]:
    """Return where on a polyline the places nearest to some points are.

    Args:
        corners: of the polyline [m], shape (k, 3), k at least 1.
        points: [m], shape (m, 3).

    Returns:
        The places, counted in corners and their shares, shape (m,), and the distances [m], shape (m,).
    """
    begins = corners[:-1] if len(corners) > 1 else corners
    ways = np.diff(corners, axis=0) if len(corners) > 1 else np.zeros((1, 3))
    squares = np.maximum(np.einsum("ki,ki->k", ways, ways), np.finfo(float).tiny)
    away = points[:, None] - begins
    shares = np.clip(np.einsum("mki,ki->mk", away, ways) / squares, 0.0, 1.0)
    left = away - shares[..., None] * ways
    distances = np.einsum("mki,mki->mk", left, left)
    best = distances.argmin(axis=1)
    rows = np.arange(len(points))
    return best + shares[rows, best], np.sqrt(distances[rows, best])


def at(corners: Array, places: Array) -> Array:
    """Return what lies at places of a polyline, linear between its corners; shape (m, 3)."""
    numbers = np.arange(len(corners))
    return np.column_stack([np.interp(places, numbers, column) for column in corners.T])


def length(corners: Array) -> Array:
    """Return the length of the polyline up to each of its corners [m], shape (k,)."""
    steps = np.linalg.norm(np.diff(corners, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(steps)])


def evenly(corners: Array, count: int) -> Array:
    """Return the places of points that divide a polyline evenly, its ends among them, shape (count,)."""
    way = length(corners)
    return np.interp(np.linspace(0.0, way[-1], count), way, np.arange(len(corners)))
