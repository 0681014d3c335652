"""A retimed trajectory, or why it is infeasible at any speed."""

from typing import Protocol, cast

import numpy as np

from ropsim.motion.curves.path import JointPoints
from ropsim.motion.retiming.binding import BindingConstraint
from ropsim.motion.retiming.constraint_rows import ConstraintRows, PathMotion
from ropsim.motion.retiming.joint_bounds import Quantity
from ropsim.motion.retiming.nominal_time import NominalTime
from ropsim.motion.retiming.smooth_rates_kernel import LEAST_RATE
from ropsim.motion.retiming.utilisation import ROUNDING
from ropsim.spatial import Array, record


class Motion(Protocol):
    """A planned motion over nominal time φ, at rest at both ends, within the limits of its paths."""

    @property
    def duration(self) -> float:
        """Return the nominal time of the end [s]."""

    def at(self, phi: Array) -> JointPoints:
        """Return the coordinates at nominal times [s], (k,), and their derivatives by φ.

        The arrays are new; the caller may write to them.
        """

    def path_motion(self, phi: Array) -> PathMotion:
        """Return how paths with limits of their own are traversed at nominal times [s], rising, (k,)."""


@record
class Slowed:
    """A part of a motion that goes slower than it was planned.

    Attributes:
        start: nominal time at which slowing begins [s].
        end: nominal time at which the plan's speed is there again [s].
        share: least rate in between, in ]0, 1[.
        joint: index of the joint with the greatest excess of the plan between the two.
        quantity: quantity of the excess.
    """

    start: float
    end: float
    share: float
    joint: int
    quantity: Quantity


@record
class RetimedTrajectory:
    """A motion within its limits at every control tick.

    Attributes:
        clock: nominal time over real time.
        slowed: the parts that are slowed, in order; none where the plan is within the limits.
        phi: nominal times at the control ticks 0, 1, 2 … until it rests, see `Ticks` [s], shape (k,).
        rows: coordinates, speeds and accelerations by real time there; a plan that takes them over ends with
            them exactly at rest.
    """

    clock: NominalTime
    slowed: tuple[Slowed, ...]
    phi: Array
    rows: JointPoints


@record
class Infeasible:
    """The first grid point at which no speed keeps the limits.

    Attributes:
        phi: nominal time of the grid point [s].
        joint: index of the joint.
        quantity: quantity of the excess.
        value: how much of that it would take [unit of the quantity], at the least speed that counts.
        limit: limit of the joint.
    """

    phi: float
    joint: int
    quantity: Quantity
    value: float
    limit: float


_POWERS = (1, 2, 3, 2)
"""Of the rate, with which the quantities grow."""
_TINY = 1e-300


def too_heavy(requested: ConstraintRows, grid_phi: Array) -> Infeasible | None:
    """Return the first grid point at which dry friction and gravity take more torque than there is.

    Args:
        requested: constraint rows of the plan.
        grid_phi: parameter of the path, shape (m,).
    """
    most = requested.bounds.effort
    if most is None or requested.effort is None:
        return None
    beyond = np.abs(requested.still) > most * (1.0 + ROUNDING)
    if not beyond.any():
        return None
    where, joints = np.nonzero(beyond)
    i, j = int(where[0]), int(joints[0])
    return Infeasible(
        float(grid_phi[i]), j, Quantity.TORQUE, float(abs(requested.still[i, j])), float(most[j])
    )


def too_slow(requested: ConstraintRows, grid_phi: Array, binding: BindingConstraint) -> Infeasible:
    """Return the refusal for a grid point that would require almost no speed.

    Args:
        requested: constraint rows of the plan.
        grid_phi: nominal times [s], shape (m,).
        binding: binding constraint there.
    """
    bounds, kind = requested.bounds, tuple(Quantity).index(binding.quantity)
    limits = (bounds.speed, bounds.acceleration, bounds.jerk, cast("Array", bounds.effort))
    limit = float(limits[kind][binding.joint])
    over = (LEAST_RATE / max(binding.rate, _TINY)) ** _POWERS[kind]
    value = limit * max(over, 1.0)
    return Infeasible(float(grid_phi[binding.point]), binding.joint, binding.quantity, value, limit)
