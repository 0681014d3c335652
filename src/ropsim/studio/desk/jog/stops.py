"""Where a jogged arm stops: at the limits of its axes, and of the joints that follow them."""

import numpy as np

from ropsim.model import RobotModel, coupled_limits
from ropsim.spatial import Array

ROUNDS = 50
"""How often limits of axes and of joints that follow them are met in turn."""


def within_limits(robot: RobotModel, wanted: Array) -> Array:
    """Return the coordinates within all limits that are near to some [rad | m], shape (n,).

    Each axis stops at its limit. A joint that follows several axes stops at its own, by the least motion of
    these axes; where that takes one of them beyond its limit, the others give way.

    Args:
        robot: the arm.
        wanted: [rad | m], shape (n,).
    """
    lower, upper, coupled = robot.lower_limits, robot.upper_limits, coupled_limits(robot)
    q = np.clip(wanted, lower, upper)
    for _ in range(ROUNDS if coupled.joints else 0):
        values = coupled.values(q)
        over = np.clip(values, coupled.lower, coupled.upper) - values
        if not over.any():
            break
        worst = int(np.argmax(np.abs(over)))
        row = coupled.T[worst]
        q = np.clip(q + row * (over[worst] / float(row @ row)), lower, upper)
    return np.asarray(q)
