"""How much of the limits is planned with, place by place, so that what is followed keeps them all."""

import math
from dataclasses import dataclass

import numpy as np

from ropsim.motion.limits.rounding_kernel import greatest_nearby
from ropsim.motion.limits.strain import Strain
from ropsim.spatial import Array

_MORE = 0.01
"""What is taken off beyond the excess, in the first round."""
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


def less(shares: Shares, found: Strain, sigma: Array) -> Shares:
    """Return shares that are smaller around the control ticks at which a limit is exceeded.

    Args:
        shares: those that were planned with.
        found: what came of them, with lacks at the m places.
        sigma: places in windows, see `smooth_course`, shape (m,).
    """
    rate, swing, width, torque = (_factor(sigma, lacks) for lacks in found.lacks)
    return Shares(
        shares.acceleration / swing,
        shares.torque / torque,
        shares.rate / rate,
        np.minimum(shares.width * width, _WIDEST),
    )


def _factor(sigma: Array, lacks: Array) -> Array | float:
    """Return the factors for the greatest lacks in the windows around places, shape (m,); 1 for no lack."""
    if not lacks.any():
        return 1.0
    nearby, queue = np.empty((2, len(lacks)))
    greatest_nearby(sigma, lacks, queue, nearby)
    return np.asarray(np.exp(nearby))


def more_than_lacks(attempt: int) -> float:
    """Return what is taken off beyond the lacks, as a logarithm: each attempt takes more.

    Args:
        attempt: how many there were before.
    """
    return math.log1p(_MORE * (attempt + 1))
