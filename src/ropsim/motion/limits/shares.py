"""How much of the limits is planned with, place by place, so that what is followed keeps them all."""

from dataclasses import dataclass

import numpy as np

from ropsim.motion.limits.grid import onto
from ropsim.motion.limits.reference import ROUNDING, Reference
from ropsim.motion.limits.rounding import greatest_nearby
from ropsim.spatial import Array

_MOST_AT_ONCE = 2.0
_MORE = 0.01
"""What is taken off beyond the excess, in the first round; each round takes more."""
_WIDEST = 8.0


@dataclass(frozen=True, slots=True, eq=False)
class Shares:
    """What is used at each of m places, each of shape (m,).

    Attributes:
        acceleration: of the bounds of acceleration, in ]0, 1].
        torque: of what dry friction and gravity leave of the bounds of torque, in ]0, 1].
        rate: of the greatest rate, in ]0, 1].
        width: windows of rounding over their first width, from 1 on.
    """

    acceleration: Array
    torque: Array
    rate: Array
    width: Array


def all_of_it(m: int) -> Shares:
    """Return the shares to begin with."""
    return Shares(*(np.ones(m) for _ in range(4)))


def less(shares: Shares, found: Reference, places: Array, sigma: Array, attempt: int) -> Shares:
    """Return shares that are smaller around the control ticks at which a limit is exceeded.

    Jerk has three causes: the path itself asks for a lower rate, changes of rate on a bent path for lower
    accelerations, changes of acceleration along the path for wider windows.

    Args:
        shares: those that were planned with.
        found: what came of them.
        places: motion times [s], shape (m,).
        sigma: places in windows, see `window_places`, shape (m,).
        attempt: how many times this has been done.
    """
    more = np.log1p(_MORE * (attempt + 1))
    speed, acceleration, jerk, torque = (
        np.where(over > 1.0 + ROUNDING, np.log(np.clip(over, 1.0, _MOST_AT_ONCE)) + more, 0.0)
        for over in found.excess
    )
    path, bend, change = found.jerk_causes
    rate = np.maximum(speed, path * jerk / 3.0).max(axis=1)
    swing = np.maximum(acceleration, (bend + 0.2 * change) * jerk).max(axis=1)
    wide = (change * jerk).max(axis=1)
    by_rate, by_swing, by_torque, by_width = (
        np.exp(greatest_nearby(sigma, onto(places, found.phi, each, 0.0)))
        for each in (rate, swing, torque.max(axis=1), wide)
    )
    return Shares(
        shares.acceleration / by_swing,
        shares.torque / by_torque,
        shares.rate / by_rate,
        np.minimum(shares.width * by_width, _WIDEST),
    )
