"""Orientation error along a path: attained and commanded orientation at the same place of the path."""

import math

import numpy as np

from ropsim.spatial import Array
from ropsim.views.accuracy.polyline import nearest

POINTS = 50
"""Points of a path at which orientations are compared."""
LAG = 0.5
"""Time by which the arm may be behind its command [s]."""
_STANDS = 1e-6
"""Length below which a path has no places [m]."""


def largest_angle(time: Array, command: tuple[Array, Array], attained: tuple[Array, Array]) -> float:
    """Return the path accuracy in orientation of one pass [rad], ISO 9283:1998, 8.2.

    The attained pose is compared with the commanded one at the nearest place of the path, so that the delay
    of the servo does not count. The standard gives a figure for each of three angles; the angle of the
    rotation between both orientations is at least as large as each of them.

    Args:
        time: of the rows [s], shape (k,).
        command: commanded positions [m], shape (k, 3), and orientations, unit quaternions, shape (k, 4).
        attained: attained ones, alike.

    Returns:
        The largest angle at up to 50 rows; NaN where the tool centre point stands or nothing is known.
    """
    places, turned = command
    way = np.linalg.norm(np.ptp(places, axis=0)) if len(places) else 0.0
    if not way > _STANDS or not all(np.isfinite(one).all() for one in (*command, *attained)):
        return math.nan
    worst = 0.0
    for row in np.unique(np.linspace(0, len(time) - 1, POINTS).round().astype(int)):
        first, last = np.searchsorted(time, [time[row] - LAG, time[row]], side="left")
        place, _ = nearest(places[first : last + 1], attained[0][row : row + 1])
        number, share = divmod(float(place[0]), 1.0)
        before = turned[first + int(number)]
        after = turned[min(first + int(number) + 1, len(time) - 1)]
        after = after if before @ after >= 0.0 else -after
        wanted = (1.0 - share) * before + share * after  # rows are near each other: no arc is needed
        worst = max(worst, _angle(wanted / np.linalg.norm(wanted), attained[1][row]))
    return worst


def _angle(one: Array, other: Array) -> float:
    """Return the angle between two orientations [rad]; exact for small ones, too."""
    near = other if one @ other >= 0.0 else -other
    return 4.0 * math.asin(min(float(np.linalg.norm(one - near)) / 2.0, 1.0))
