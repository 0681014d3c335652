"""Path repeatability: how far the passes of one path lie apart."""

import math
from collections.abc import Sequence

import numpy as np

from ropsim.spatial import Array
from ropsim.views.accuracy.matching import POINTS
from ropsim.views.accuracy.polyline import at, evenly, length, nearest

SAME = 1e-6
"""Distance up to which commanded paths count as the same one [m]."""


def path_repeatability(passes: Sequence[tuple[Array, Array]]) -> float:
    """Return RT_p of passes along one path [m], ISO 9283:1998, 8.3.

    At 50 points of the path the attained paths are cut with the plane at right angles to it. With distances
    l_j of the n cuts from their barycentre, their mean l̄ and standard deviation S (over n − 1),
    RT_p = max over the points of l̄ + 3 S.

    Args:
        passes: commanded and attained positions of each pass [m], shapes (k, 3); k may differ.

    Returns:
        RT_p; NaN for less than two passes, and where their commanded paths are not the same.
    """
    if len(passes) < 2:
        return math.nan
    first = passes[0][0]
    places = evenly(first, POINTS)
    points = at(first, places)
    if not length(first)[-1] > SAME or not all(_is_along(command, points) for command, _ in passes):
        return math.nan
    step = 0.5
    tangents = at(first, places + step) - at(first, places - step)
    tangents /= np.maximum(np.linalg.norm(tangents, axis=1), np.finfo(float).tiny)[:, None]
    cuts = np.array([_cuts(attained, points, tangents) for _, attained in passes])
    away = np.linalg.norm(cuts - cuts.mean(axis=0), axis=2)
    return float(np.max(away.mean(axis=0) + 3.0 * away.std(axis=0, ddof=1)))


def _is_along(command: Array, points: Array) -> bool:
    """Return whether a commanded path goes through the points and ends where they end."""
    ends = np.linalg.norm(command[[0, -1]] - points[[0, -1]], axis=1)
    return bool(max(ends.max(), nearest(command, points)[1].max()) <= SAME)


def _cuts(attained: Array, points: Array, tangents: Array) -> Array:
    """Return where a path goes through planes, shape (m, 3); the nearest place where it does not."""
    sides = np.einsum("mki,mi->mk", attained - points[:, None], tangents)
    crossed = (sides[:, :-1] <= 0.0) & (sides[:, 1:] > 0.0)
    share = -sides[:, :-1] / np.where(crossed, sides[:, 1:] - sides[:, :-1], 1.0)
    cut = attained[:-1] + share[..., None] * np.diff(attained, axis=0)
    away = np.where(crossed, np.linalg.norm(cut - points[:, None], axis=2), np.inf)
    best, rows = away.argmin(axis=1), np.arange(len(points))
    beside = at(attained, nearest(attained, points)[0])
    return np.where(np.isfinite(away[rows, best])[:, None], cut[rows, best], beside)
