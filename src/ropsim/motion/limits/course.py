"""Motion time below given rates: smooth, with windows as long as the jerk limits need them."""

import numpy as np

from ropsim.motion.limits.demand import LEAST_RATE, Demand
from ropsim.motion.limits.motion_time import MotionTime, motion_time
from ropsim.motion.limits.rounding import gently, rounded, window_places
from ropsim.spatial import Array

_FEWEST_CELLS = 5.0
"""Half width of the least window over the way between places."""
_SLOPE = 0.6
"""Greatest change of the width along the motion, so that a window far off a dip does not reach it."""
_SWING = 0.5
"""Half width of a window over the time in which the jerk limit lets acceleration go from 0 to its limit."""
_ENDLESS = 1e100


def course_below(places: Array, rates: Array, lasting: Array, width: Array) -> tuple[Array, MotionTime]:
    """Return the places in windows, see `window_places`, shape (m,), and the motion time.

    Args:
        places: motion times [s], rising, shape (m,).
        rates: nowhere exceeded, but for the least rate that counts, shape (m,).
        lasting: real times that windows last at least, see `window_times` [s], shape (m,).
        width: factor of the windows, shape (m,).
    """
    ways = np.diff(places)
    cells = np.maximum(np.append(ways, 0.0), np.append(0.0, ways))
    rates = np.maximum(rates, LEAST_RATE)
    widths = np.maximum(lasting * rates, _FEWEST_CELLS * cells) * width
    widths = np.maximum(gently(places, widths, _SLOPE), cells)
    sigma = window_places(places, widths)
    smooth, slopes = rounded(sigma, rates)
    return sigma, motion_time(places, smooth, smooth * slopes / widths)


def window_times(asked: Demand, longest: float) -> Array:
    """Return how long windows last, so that jerk limits let accelerations swing in them [s], shape (m,).

    Args:
        asked: what the plan asks of the joints.
        longest: bound of the result [s].
    """
    bounds, way = asked.bounds, np.abs(asked.points.d1) + np.finfo(np.float64).eps
    along = np.minimum(np.min(bounds.acceleration / way, axis=1), _ENDLESS)
    by_acceleration = along * np.max(way / bounds.jerk, axis=1)
    by_speed = np.sqrt(np.max(np.minimum(bounds.speed, _ENDLESS) / bounds.jerk))
    return np.asarray(_SWING * np.minimum(np.minimum(by_acceleration, by_speed), longest))
