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
    columns = np.ascontiguousarray(corners.T)
    begins = columns[:, :-1] if len(corners) > 1 else columns
    ways = np.diff(columns, axis=1) if len(corners) > 1 else np.zeros((3, 1))
    shares, squares = nearest_shares(points.T[:, :, None] - begins[:, None], ways[:, None])
    best = squares.argmin(axis=1)
    rows = np.arange(len(points))
    return best + shares[rows, best], np.sqrt(squares[rows, best])


def nearest_shares(away: Array, ways: Array) -> tuple[Array, Array]:
    """Return where on pieces of a polyline the places nearest to points are.

    Coordinates come first: sums of three numbers that lie side by side would take most of the time.

    Args:
        away: points from the starts of pieces [m], shape (3, m, k).
        ways: from start to end of each piece [m], shape (3, m, k), or (3, 1, k) the same ones for all points.

    Returns:
        Shares of the pieces in [0, 1], and squares of the distances that are left [m²], shape (m, k) each.
    """
    squares = np.maximum(_dot(ways, ways), np.finfo(float).tiny)
    shares = np.minimum(np.maximum(_dot(away, ways) / squares, 0.0), 1.0)
    left = away - shares * ways
    return shares, _dot(left, left)


def _dot(some: Array, others: Array) -> Array:
    products = some * others
    return np.asarray(products[0] + products[1] + products[2])


def at(corners: Array, places: Array) -> Array:
    """Return the points at distances along a polyline, linear between its corners; shape (m, 3)."""
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
