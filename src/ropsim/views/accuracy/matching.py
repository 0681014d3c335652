"""Orientation error along a path: attained and commanded orientation at the same place of the path."""

import math

import numpy as np

from ropsim.spatial import Array
from ropsim.views.accuracy.polyline import nearest_shares

POINTS = 50
"""Points of a path at which orientations are compared."""
LAG = 0.2
"""Time by which the arm may be behind its command [s]."""
_STANDS = 1e-6
"""Length below which a path has no places [m]."""


def largest_angle(time: Array, command: tuple[Array, Array], attained: tuple[Array, Array]) -> float:
    """Return the path accuracy in orientation of one pass [rad], ISO 9283:1998, 8.2.

    The attained pose is compared with the commanded one at the nearest place of the path, so that the delay
    of the servo does not count. The standard has a figure for each of three angles; the angle of the rotation
    between both orientations is at least as large as each of them.

    Args:
        time: of the rows [s], shape (k,).
        command: commanded positions [m], shape (k, 3), and orientations, unit quaternions, shape (k, 4).
        attained: attained ones, alike.

    Returns:
        The largest angle at up to 50 rows; NaN where the tool centre point stands or nothing is known.
    """
    places, turned = command
    way = np.linalg.norm(np.ptp(places, axis=0)) if len(places) else 0.0
    if len(time) < 2 or not way > _STANDS or not all(np.isfinite(one).all() for one in (*command, *attained)):
        return math.nan
    rows = np.unique(np.linspace(0, len(time) - 1, POINTS).round().astype(int))
    back = int((rows - np.searchsorted(time, time[rows] - LAG)).max())
    behind = np.maximum(rows[:, None] - np.arange(back, -1, -1), 0)  # a row of rows up to each one
    columns = np.ascontiguousarray(places.T)[:, behind]
    begins, ways = columns[:, :, :-1], np.diff(columns, axis=2)
    away = attained[0][rows].T[:, :, None] - begins
    shares, squares = nearest_shares(away, ways)
    best, all_rows = squares.argmin(axis=1), np.arange(len(rows))
    share = shares[all_rows, best][:, None]
    before, after = turned[behind[all_rows, best]], turned[behind[all_rows, best + 1]]
    after = after * _sides(before, after)
    wanted = (1.0 - share) * before + share * after  # rows are near each other: no arc is needed
    wanted /= np.linalg.norm(wanted, axis=1)[:, None]
    had = attained[1][rows]
    apart = np.linalg.norm(had * _sides(wanted, had) - wanted, axis=1)
    return float(4.0 * np.arcsin(np.minimum(apart / 2.0, 1.0)).max())  # exact also for small angles


def _sides(some: Array, others: Array) -> Array:
    """Return 1 where two quaternions are on one side of the sphere and −1 where not, shape (m, 1)."""
    return np.where(np.einsum("mi,mi->m", some, others) < 0.0, -1.0, 1.0)[:, None]
