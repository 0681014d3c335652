"""A motion in its nominal time at control ticks, and its utilisation of the limits there."""

from dataclasses import dataclass

import numpy as np

from ropsim.motion.curves.path import JointPoints
from ropsim.motion.retiming.constraint_rows import ConstraintRows
from ropsim.motion.retiming.joint_bounds import Effort, JointBounds, Ticks, checked_torques, no_torques
from ropsim.motion.retiming.nominal_time import NominalTime
from ropsim.motion.retiming.nominal_time_kernel import (
    AT_ONCE,
    ROWS_OF_LOAD,
    ROWS_OF_RATES,
    beyond_torque,
    walk_at,
)
from ropsim.motion.retiming.retimed import Motion
from ropsim.motion.retiming.utilisation import ROUNDING, Going, Utilisation, strain
from ropsim.spatial import Array

_CLEARLY = (1.0 + ROUNDING) * (1.0 - 1e-12)
"""Share of a limit below which rounding does not decide whether it is kept."""


@dataclass(frozen=True, slots=True, eq=False)
class Walked:
    """A motion in its nominal time, at k control ticks.

    Attributes:
        timing: nominal times [s], rates, and changes of these [1/s], shape (3, k).
        points: the joints by nominal time.
        rows: coordinates, speeds and accelerations by real time.
        keeps_motion: whether joints clearly keep their limits of speed, acceleration and jerk.
    """

    timing: Array
    points: JointPoints
    rows: JointPoints
    keeps_motion: bool


def walked(motion: Motion, clock: NominalTime, bounds: JointBounds, ticks: Ticks) -> Walked:
    """Return a motion in its nominal time.

    qd = q'·w and qdd = q''·w² + q'·c, with the rate w of nominal time and its change c.

    Args:
        motion: the plan.
        clock: its nominal time.
        bounds: capabilities of the joints.
        ticks: of control.
    """
    timing = clock.at(ticks.times(clock.duration))
    points = motion.at(timing[0])
    first, second = np.ascontiguousarray(points.d1), np.ascontiguousarray(points.d2)
    limits = np.array([bounds.speed, bounds.acceleration, ticks.period * bounds.jerk]) * _CLEARLY
    rates, beyond = np.empty((2, *points.q.shape)), np.empty(1)
    room = np.empty((ROWS_OF_RATES, AT_ONCE * limits.shape[1]))
    walk_at(first, second, timing, limits, room, rates.reshape(2, -1), beyond)
    return Walked(timing, points, JointPoints(points.q, rates[0], rates[1]), bool(beyond[0] < 0.0))


def keeps_torque(rows: JointPoints, bounds: JointBounds, effort: Effort | None) -> bool:
    """Return whether no row takes more torque than there is but by rounding.

    Raises:
        ProfileError: M540, torques are no numbers.
    """
    if effort is None or bounds.effort is None:
        return True
    return _keeps(checked_torques(effort, rows.q, rows.d1, rows.d2), rows, bounds.effort * (1.0 + ROUNDING))


def utilisation_at_ticks(
    walk: Walked, motion: Motion, demand: ConstraintRows, places: Array, period: float, more: float
) -> Utilisation | None:
    """Return the utilisation of the limits by a motion in nominal time, None where it clearly keeps all.

    Args:
        walk: the motion at control ticks.
        motion: the plan.
        demand: constraint rows at the grid points.
        places: nominal times [s], shape (m,).
        period: of the control ticks [s].
        more: added to each lack, see `strain`.

    Raises:
        ProfileError: M540, as for `strain`, or torques are no numbers.
    """
    rows, bounds, torque = walk.rows, demand.bounds, None
    is_kept = walk.keeps_motion and demand.ways.speeds.shape[1] == 0
    if demand.effort is not None and bounds.effort is not None:
        torque = checked_torques(demand.effort, rows.q, rows.d1, rows.d2)
        is_kept = _keeps(torque, rows, bounds.effort * _CLEARLY) and is_kept
    if is_kept:
        return None
    going = Going(walk.points, motion.ways(walk.timing[0]), walk.timing, places, demand.still)
    return strain(rows, torque, bounds, period, going, more)


def _keeps(torque: Array, rows: JointPoints, most: Array) -> bool:
    """Return whether no torque is above its limit [N m | N]; an error where one is no number."""
    room, beyond = np.empty((ROWS_OF_LOAD, AT_ONCE * len(most))), np.empty(1)
    beyond_torque(torque.reshape(-1), most, room, beyond)
    if not beyond[0] < np.inf and not np.isfinite(torque).all():
        raise no_torques(torque, rows.q)
    return bool(beyond[0] <= 0.0)
