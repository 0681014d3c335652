"""Why a motion cannot be made within its limits at any speed."""

from typing import cast

import numpy as np

from ropsim.motion.limits.course_kernel import LEAST_RATE
from ropsim.motion.limits.demand import Demand
from ropsim.motion.limits.joint_bounds import Quantity
from ropsim.motion.limits.kept import Beyond
from ropsim.motion.limits.need import Need
from ropsim.motion.limits.strain import ROUNDING
from ropsim.spatial import Array

_POWERS = (1, 2, 3, 2)
"""Of the rate, with which the quantities grow."""
_TINY = 1e-300


def too_heavy(asked: Demand, places: Array) -> Beyond | None:
    """Return the first place at which dry friction and gravity take more torque than there is.

    Args:
        asked: what the plan asks of the joints.
        places: parameter of the path, shape (m,).
    """
    most = asked.bounds.effort
    if most is None or asked.effort is None:
        return None
    beyond = np.abs(asked.still) > most * (1.0 + ROUNDING)
    if not beyond.any():
        return None
    where, joints = np.nonzero(beyond)
    i, j = int(where[0]), int(joints[0])
    return Beyond(float(places[i]), j, Quantity.TORQUE, float(abs(asked.still[i, j])), float(most[j]))


def too_slow(asked: Demand, places: Array, need: Need) -> Beyond:
    """Return the refusal for a place that would have to be gone at next to no speed.

    Args:
        asked: what the plan asks of the joints.
        places: motion times [s], shape (m,).
        need: what is needed most there.
    """
    bounds, kind = asked.bounds, tuple(Quantity).index(need.quantity)
    limits = (bounds.speed, bounds.acceleration, bounds.jerk, cast("Array", bounds.effort))
    limit = float(limits[kind][need.joint])
    over = (LEAST_RATE / max(need.rate, _TINY)) ** _POWERS[kind]
    value = limit * max(over, 1.0)
    return Beyond(float(places[need.place]), need.joint, need.quantity, value, limit)
