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
        asked: what the plan asks of joints and paths.
        longest: bound of the result [s].
    """
    bounds, ways = asked.bounds, asked.ways
    way = np.abs(asked.along()[0]) + np.finfo(np.float64).eps
    jerk = np.hstack((np.broadcast_to(bounds.jerk, asked.points.q.shape), ways.most_jerks))
    along = np.minimum(np.min(asked.most() / way, axis=1), _ENDLESS)
    by_acceleration = along * np.max(way / jerk, axis=1)
    fast = np.append(np.minimum(bounds.speed, _ENDLESS) / bounds.jerk, np.abs(ways.speeds) / ways.most_jerks)
    by_speed = np.sqrt(np.max(fast))
    return np.asarray(_SWING * np.minimum(np.minimum(by_acceleration, by_speed), longest))
