"""How far at most points lie outside of a hull."""

import numpy as np

from ropsim.collision.gjk_kernel import distances
from ropsim.spatial import Array

AT_ONCE = 64
"""Distances that are computed before they are compared with the bound."""


def shortfall(corners: Array, points: Array, bounds: Array) -> float:
    """Return the greatest distance of points from the hull of corners [m].

    The distances are exact; points are evaluated in order of the upper bound of their distance, until no
    other one can be farther.

    Args:
        corners: [m], shape (c, 3).
        points: [m], shape (k, 3).
        bounds: upper bound of the distance of each [m], shape (k,).
    """
    order = np.argsort(-bounds, kind="stable")
    greatest = 0.0
    for start in range(0, len(order), AT_ONCE):
        some = order[start : start + AT_ONCE]
        if bounds[some[0]] <= greatest:
            break
        greatest = max(greatest, float(_distances(corners, points[some]).max()))
    return greatest


def from_triangles(points: Array, triangles: Array) -> Array:
    """Return the distance of each point from its triangle [m], shape (k,).

    Args:
        points: [m], shape (k, 3).
        triangles: corners of each [m], shape (k, 3, 3); an edge has a corner twice, a point three times.
    """
    starts, ends = triangles, np.roll(triangles, -1, axis=1)
    edges, rays = ends - starts, points[:, np.newaxis] - starts
    normal = np.cross(edges[:, 0], edges[:, 1])
    area = np.linalg.norm(normal, axis=1)
    sides = np.einsum("ksi,ksi->ks", np.cross(normal[:, np.newaxis], edges), rays)
    above = (area > 0.0) & (sides >= 0.0).all(axis=1)
    lengths = np.einsum("ksi,ksi->ks", edges, edges)
    share = np.clip(np.einsum("ksi,ksi->ks", rays, edges) / np.where(lengths > 0.0, lengths, 1.0), 0.0, 1.0)
    to_edges = np.linalg.norm(rays - share[..., np.newaxis] * edges, axis=2).min(axis=1)
    height = np.abs(np.einsum("ki,ki->k", normal, rays[:, 0])) / np.where(area > 0.0, area, 1.0)
    return np.asarray(np.where(above, height, to_edges))


def _distances(corners: Array, points: Array) -> Array:
    """Return the distance of each point from the hull of corners [m], shape (k,)."""
    count, first = len(points), len(corners)
    numbers = np.arange(first, first + count, dtype=np.float64)
    bodies = np.zeros((count + 1, 4))
    bodies[0, 1] = first
    bodies[1:, 0], bodies[1:, 1] = numbers, numbers + 1.0
    poses = np.tile([*np.eye(3).ravel(), 0.0, 0.0, 0.0], (count + 1, 1))
    pairs = np.column_stack([np.zeros(count), np.arange(1.0, count + 1.0)])
    found, work = np.empty((count, 7)), np.zeros((17, 4))
    every = np.vstack([corners, points])
    distances(every, bodies, poses, pairs, np.zeros(count), np.array([np.inf, np.inf]), work, found)
    return found[:, 0]
