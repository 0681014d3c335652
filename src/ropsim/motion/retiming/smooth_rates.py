"""Motion time below given rates: smooth, with windows as long as the jerk limits need them."""

import numpy as np

from ropsim.motion.retiming.constraint_rows import ConstraintRows
from ropsim.motion.retiming.nominal_time import NominalTime
from ropsim.motion.retiming.smooth_rates_kernel import WORK, smooth_course, windows_last
from ropsim.spatial import Array

_ENDLESS = 1e100


def course_below(places: Array, x: Array, lasting: Array, width: Array) -> tuple[Array, NominalTime]:
    """Return the places in windows, see `smooth_course`, shape (m,), and the motion time.

    Args:
        places: motion times [s], rising, shape (m,).
        x: squares of rates; these are nowhere exceeded, but for the least rate that counts, shape (m,).
        lasting: real times that windows last at least, see `window_times` [s], shape (m,).
        width: factor of the windows, shape (m,).
    """
    m = len(places)
    sigma, times, smooth, changes = np.empty((4, m))
    smooth_course(places, x, lasting, width, np.empty((2 + WORK, m + 2)), sigma, times, smooth, changes)
    return sigma, NominalTime(times, places, smooth, changes)


def window_times(asked: ConstraintRows, longest: float) -> Array:
    """Return how long windows last, so that jerk limits let accelerations swing in them [s], shape (m,).

    Args:
        asked: what the plan asks of joints and paths.
        longest: bound of the result [s].
    """
    bounds, ways = asked.bounds, asked.ways
    fast = np.append(np.minimum(bounds.speed, _ENDLESS) / bounds.jerk, np.abs(ways.speeds) / ways.most_jerks)
    lasting = np.empty(len(asked.points.q))
    windows_last(
        asked.along()[0], asked.most(), asked.most_jerk(), float(np.sqrt(fast.max())), longest, lasting
    )
    return lasting
