"""At which rate each joint could keep each of its limits, place by place."""

import numpy as np

from ropsim.motion.limits.demand import Demand
from ropsim.motion.limits.joint_bounds import torques
from ropsim.spatial import Array

_TINY = 1e-300


def rates_needed(demand: Demand, places: Array, period: float) -> Array:
    """Return the constant rates that would just keep a limit, in the order of `Quantity`, shape (4, m, n).

    With the rate w, speeds scale by w, accelerations and what motion adds to the torques by w², jerk by w³;
    where acceleration is not steady, its step in one control tick by w².

    Args:
        demand: what the plan asks of the joints at the places.
        places: motion times [s], shape (m,).
        period: of the control ticks [s].
    """
    points, bounds = demand.points, demand.bounds
    result = np.full((4, *points.q.shape), np.inf)
    result[0] = bounds.speed / np.maximum(np.abs(points.d1), _TINY)
    result[1] = np.sqrt(bounds.acceleration / np.maximum(np.abs(points.d2), _TINY))
    steps = np.maximum(np.abs(np.diff(points.d2, axis=0)), _TINY)
    lasting = np.cbrt(bounds.jerk * np.diff(places)[:, None] / steps)
    sudden = np.sqrt(bounds.jerk * period / steps)
    between = np.maximum(lasting, sudden)
    result[2, :-1], result[2, -1] = between, between[-1]
    result[2, 1:] = np.minimum(result[2, 1:], between)
    if demand.effort is not None and bounds.effort is not None:
        torque = torques(demand.effort, points.q, points.d1, points.d2)
        sign = np.where(torque - demand.still < 0.0, -1.0, 1.0)
        room = np.maximum(bounds.effort - sign * demand.still, 0.0)
        result[3] = np.sqrt(room / np.maximum(np.abs(torque - demand.still), _TINY))
    return result
