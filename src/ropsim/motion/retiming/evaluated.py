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
    evaluate_at,
)
from ropsim.motion.retiming.retimed import Motion
from ropsim.motion.retiming.utilisation import ROUNDING, Going, Utilisation, utilisation_of_rows
from ropsim.spatial import Array

_CLEARLY = (1.0 + ROUNDING) * (1.0 - 1e-12)
"""Share of a limit below which rounding does not decide whether it is kept."""


@dataclass(frozen=True, slots=True, eq=False)
class EvaluatedMotion:
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


def evaluate_motion(motion: Motion, clock: NominalTime, bounds: JointBounds, ticks: Ticks) -> EvaluatedMotion:
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
    work = np.empty((ROWS_OF_RATES, AT_ONCE * limits.shape[1]))
    evaluate_at(first, second, timing, limits, work, rates.reshape(2, -1), beyond)
    return EvaluatedMotion(timing, points, JointPoints(points.q, rates[0], rates[1]), bool(beyond[0] < 0.0))


def keeps_torque(rows: JointPoints, bounds: JointBounds, effort: Effort | None) -> bool:
    """Return whether no row takes more torque than there is but by rounding.

    Raises:
        ProfileError: M540, torques are no numbers.
    """
    if effort is None or bounds.effort is None:
        return True
    return _keeps(checked_torques(effort, rows.q, rows.d1, rows.d2), rows, bounds.effort * (1.0 + ROUNDING))


def utilisation_at_ticks(
    evaluated: EvaluatedMotion,
    motion: Motion,
    constraints: ConstraintRows,
    grid_phi: Array,
    period: float,
    more: float,
) -> Utilisation | None:
    """Return the utilisation of the limits by a motion in nominal time, None where it clearly keeps all.

    Args:
        evaluated: the motion at control ticks.
        motion: the plan.
        constraints: constraint rows at the grid points.
        grid_phi: nominal times [s], shape (m,).
        period: of the control ticks [s].
        more: added to each lack, see `utilisation_of_rows`.

    Raises:
        ProfileError: M540, as for `utilisation_of_rows`, or torques are no numbers.
    """
    rows, bounds, torque = evaluated.rows, constraints.bounds, None
    is_within = evaluated.keeps_motion and constraints.path_motion.speeds.shape[1] == 0
    if constraints.effort is not None and bounds.effort is not None:
        torque = checked_torques(constraints.effort, rows.q, rows.d1, rows.d2)
        is_within = _keeps(torque, rows, bounds.effort * _CLEARLY) and is_within
    if is_within:
        return None
    going = Going(
        evaluated.points,
        motion.path_motion(evaluated.timing[0]),
        evaluated.timing,
        grid_phi,
        constraints.still,
    )
    return utilisation_of_rows(rows, torque, bounds, period, going, more)


def _keeps(torque: Array, rows: JointPoints, most: Array) -> bool:
    """Return whether no torque is above its limit [N m | N]; an error where one is no number."""
    work, beyond = np.empty((ROWS_OF_LOAD, AT_ONCE * len(most))), np.empty(1)
    beyond_torque(torque.reshape(-1), most, work, beyond)
    if not beyond[0] < np.inf and not np.isfinite(torque).all():
        raise no_torques(torque, rows.q)
    return bool(beyond[0] <= 0.0)
