"""The trapezoidal time law of a path: bounded speed and acceleration, and next to no limit of the jerk."""

import numpy as np

from ropsim.motion.time_law.jerk_limited import jerk_limited
from ropsim.motion.time_law.piecewise_law import PiecewiseLaw
from ropsim.spatial import Array

ACCELERATION_RISE = 1e-5
"""Time in which the acceleration comes to its bound [s]: far less than a control tick."""
_ACCELERATION, _JERK = 2, 3


def trapezoidal(bounds: Array, counts: Array) -> PiecewiseLaw:
    """Return the time law of intervals with constant acceleration, constant speed and constant braking.

    It is that of `jerk_limited` with the acceleration built up within 10 µs, so that it goes on over the ends
    of path segments and keeps the bounds of each; a move from rest to rest takes s/v + v/a, or 2·√(s/a) where
    it does not come to its speed, and 10 µs more.

    Args:
        bounds: as for `jerk_limited`, shape (s, 6); jerks do not count.
        counts: how many path limits each path segment has, shape (p,).

    Raises:
        ProfileError: M540, as there.
    """
    steep = np.array(bounds)
    steep[:, _JERK] = steep[:, _ACCELERATION] / ACCELERATION_RISE
    return jerk_limited(steep, counts)
