"""At which rate the joints could keep their limits, place by place, and which one needs the lowest."""

from dataclasses import dataclass

import numpy as np

from ropsim.motion.retiming.constraint_kernel import least_rate, rates_within
from ropsim.motion.retiming.constraint_rows import ConstraintRows
from ropsim.motion.retiming.joint_bounds import Quantity, torques
from ropsim.spatial import Array


@dataclass(frozen=True, slots=True)
class Need:
    """The lowest rate that one limit of one joint needs.

    Attributes:
        quantity: that is limited.
        place: index of the place.
        joint: index of the joint.
        rate: constant rate that would just keep the limit there.
    """

    quantity: Quantity
    place: int
    joint: int
    rate: float


def rates_needed(demand: ConstraintRows, places: Array, period: float) -> Array:
    """Return the constant rates, at most 1, that would just keep the limits of speed and jerk, (m,).

    Args:
        demand: constraint rows of the plan at the grid points.
        places: nominal times [s], shape (m,).
        period: of the control ticks [s].
    """
    inverse, rates = 1.0 / np.array([demand.bounds.speed, demand.bounds.jerk]), np.empty(len(places))
    rates_within(*_rows(demand), places, inverse, period, rates)
    return rates


def binding_constraint(demand: ConstraintRows, places: Array, period: float, begin: int, end: int) -> Need:
    """Return the binding constraint, with the lowest rate, among some grid points.

    With the rate w, speeds scale by w, accelerations and the motion-dependent part of torques by w², jerk by
    w³; where acceleration is not steady, its step in one control tick by w².

    Args:
        demand: constraint rows of the plan at the grid points.
        places: nominal times [s], shape (m,).
        period: of the control ticks [s].
        begin: index of the first checked grid point.
        end: index of the place behind the last one.
    """
    points, bounds, torque = demand.points, demand.bounds, demand.still
    limits = np.full((len(Quantity), len(bounds.speed)), np.inf)
    limits[:3] = bounds.speed, bounds.acceleration, bounds.jerk
    if demand.effort is not None and bounds.effort is not None:
        limits[3] = bounds.effort
        here = slice(begin, end)
        torque = torques(demand.effort, points.q[here], points.d1[here], points.d2[here])
    found = np.zeros(4)
    torque, still = np.ascontiguousarray(torque), np.ascontiguousarray(demand.still)
    least_rate(*_rows(demand), torque, still, places, limits, period, begin, end, found)
    kind, place, joint = found[:3].astype(int).tolist()
    return Need(tuple(Quantity)[kind], place, joint, float(found[3]))


def _rows(demand: ConstraintRows) -> tuple[Array, Array]:
    """Return the first and second derivatives of the joints by nominal time, shape (m, n)."""
    return np.ascontiguousarray(demand.points.d1), np.ascontiguousarray(demand.points.d2)
