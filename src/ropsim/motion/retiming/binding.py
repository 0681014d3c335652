"""Rates at which joints keep their limits at each grid point, and the constraint with the lowest one."""

from dataclasses import dataclass

import numpy as np

from ropsim.motion.retiming.constraint_kernel import least_rate, rates_within
from ropsim.motion.retiming.constraint_rows import ConstraintRows
from ropsim.motion.retiming.joint_bounds import Quantity, torques
from ropsim.spatial import Array


@dataclass(frozen=True, slots=True)
class BindingConstraint:
    """The lowest rate that one limit of one joint needs.

    Attributes:
        quantity: that is limited.
        point: index of the grid point.
        joint: index of the joint.
        rate: constant rate that would just keep the limit there.
    """

    quantity: Quantity
    point: int
    joint: int
    rate: float


def rates_needed(constraints: ConstraintRows, grid_phi: Array, period: float) -> Array:
    """Return the constant rates, at most 1, that would just keep the limits of speed and jerk, (m,).

    Args:
        constraints: constraint rows of the plan at the grid points.
        grid_phi: nominal times [s], shape (m,).
        period: of the control ticks [s].
    """
    inverse, rates = (
        1.0 / np.array([constraints.bounds.speed, constraints.bounds.jerk]),
        np.empty(len(grid_phi)),
    )
    rates_within(*_rows(constraints), grid_phi, inverse, period, rates)
    return rates


def binding_constraint(
    constraints: ConstraintRows, grid_phi: Array, period: float, begin: int, end: int
) -> BindingConstraint:
    """Return the binding constraint, with the lowest rate, among some grid points.

    With the rate w, speeds scale by w, accelerations and the motion-dependent part of torques by w², jerk by
    w³; where acceleration is not steady, its step in one control tick by w².

    Args:
        constraints: constraint rows of the plan at the grid points.
        grid_phi: nominal times [s], shape (m,).
        period: of the control ticks [s].
        begin: index of the first checked grid point.
        end: index of the grid point behind the last one.
    """
    points, bounds, torque = constraints.points, constraints.bounds, constraints.still
    limits = np.full((len(Quantity), len(bounds.speed)), np.inf)
    limits[:3] = bounds.speed, bounds.acceleration, bounds.jerk
    if constraints.effort is not None and bounds.effort is not None:
        limits[3] = bounds.effort
        here = slice(begin, end)
        torque = torques(constraints.effort, points.q[here], points.d1[here], points.d2[here])
    found = np.zeros(4)
    torque, still = np.ascontiguousarray(torque), np.ascontiguousarray(constraints.still)
    least_rate(*_rows(constraints), torque, still, grid_phi, limits, period, begin, end, found)
    kind, point, joint = found[:3].astype(int).tolist()
    return BindingConstraint(tuple(Quantity)[kind], point, joint, float(found[3]))


def _rows(constraints: ConstraintRows) -> tuple[Array, Array]:
    """Return the first and second derivatives of the joints by nominal time, shape (m, n)."""
    return np.ascontiguousarray(constraints.points.d1), np.ascontiguousarray(constraints.points.d2)
