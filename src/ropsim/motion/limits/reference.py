"""References at control ticks, and what they use of the limits."""

import math
from dataclasses import dataclass

import numpy as np

from ropsim.core import keep_freed_memory
from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.limits.demand import Demand
from ropsim.motion.limits.joint_bounds import Effort, JointBounds, told_torques, torques
from ropsim.motion.limits.kept import Motion
from ropsim.motion.limits.motion_time import MotionTime
from ropsim.motion.limits.strain import ROUNDING, Going, Strain, strain, strain_as_planned, with_torque
from ropsim.motion.limits.strain_kernel import by_real_time
from ropsim.motion.limits.ticks import Ticks
from ropsim.motion.paths.path import JointPoints
from ropsim.motion.profile import ProfileError
from ropsim.spatial import Array

_MOST_TICKS = 1e8


@dataclass(frozen=True, slots=True, eq=False)
class Reference:
    """A motion at k control ticks.

    Attributes:
        phi: motion times [s], shape (k,).
        rows: coordinates, speeds and accelerations by real time.
        torque: that they take [N m | N], shape (k, n); None where it does not count.
        strain: what they use of the limits.
    """

    phi: Array
    rows: JointPoints
    torque: Array | None
    strain: Strain


def load(rows: JointPoints, bounds: JointBounds, effort: Effort | None) -> Array | None:
    """Return the torques of rows [N m | N], shape (k, n), or None where torque does not count."""
    counts = effort is not None and bounds.effort is not None
    return torques(effort, rows.q, rows.d1, rows.d2) if counts and effort else None


def keeps_torque(rows: JointPoints, bounds: JointBounds, effort: Effort | None) -> bool:
    """Return whether no row takes more torque than there is but by rounding."""
    torque = load(rows, bounds, effort)
    if torque is None or bounds.effort is None:
        return True
    return bool((np.abs(torque) <= bounds.effort * (1.0 + ROUNDING)).all())


def as_planned(motion: Motion, bounds: JointBounds, effort: Effort | None, ticks: Ticks) -> Reference:
    """Return the references of a motion that is not slowed.

    Args:
        motion: the plan, at rest at both ends.
        bounds: what the joints can do.
        effort: torques at the joints; None where they do not count.
        ticks: at which it is looked at.

    Raises:
        ProfileError: M540, the duration or the period is not above 0, or the motion or its torques are none.
    """
    keep_freed_memory()
    _check(motion.duration, ticks.period)
    phi = ticks.times(motion.duration)
    ends = phi[ticks.count(motion.duration) :]
    np.minimum(ends, motion.duration, out=ends)
    rows = motion.at(phi)
    if rows.q.shape[1:] != bounds.speed.shape:
        found = f"the motion has {rows.q.shape[1:]} joints, the bounds {bounds.speed.shape}"
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, f"{found}, allowed are the same numbers"))
    return loaded(Reference(phi, rows, None, strain_as_planned(rows, bounds, ticks.period)), bounds, effort)


def loaded(planned: Reference, bounds: JointBounds, effort: Effort | None) -> Reference:
    """Return references that are not slowed with the torques that they take.

    Args:
        planned: the references, without torques.
        bounds: what the joints can do.
        effort: torques at the joints; None where they do not count.

    Raises:
        ProfileError: M540, torques are no numbers.
    """
    rows = planned.rows
    if effort is None or bounds.effort is None:
        return planned
    torque = told_torques(effort, rows.q, rows.d1, rows.d2)
    return Reference(planned.phi, rows, torque, with_torque(planned.strain, rows, torque, bounds))


def reference(
    motion: Motion, clock: MotionTime, demand: Demand, places: Array, ticks: Ticks, more: float
) -> Reference:
    """Return the references of a motion in its motion time.

    qd = q'·w and qdd = q''·w² + q'·c, with the rate w of motion time and its change c.

    Args:
        motion: the plan.
        clock: its motion time.
        demand: what it asks of the joints at the places.
        places: motion times [s], shape (m,).
        ticks: of control.
        more: added to each lack, see `strain`.

    Raises:
        ProfileError: M540, as for `strain`.
    """
    course = clock.at(ticks.times(clock.duration))
    points = motion.at(course[0])
    rates = np.empty((2, *points.q.shape))
    by_real_time(np.ascontiguousarray(points.d1), np.ascontiguousarray(points.d2), course, rates)
    rows = JointPoints(points.q, rates[0], rates[1])
    going = Going(points, motion.ways(course[0]), course, places, demand.still)
    torque = load(rows, demand.bounds, demand.effort)
    return Reference(course[0], rows, torque, strain(rows, torque, demand.bounds, ticks.period, going, more))


def _check(duration: float, period: float) -> None:
    numbers = (duration, period)
    if not all(math.isfinite(each) and each > 0.0 for each in numbers) or duration / period > _MOST_TICKS:
        found = f"duration is {duration:g} s, control tick {period:g} s"
        allowed = f"allowed are numbers above 0, and {_MOST_TICKS:g} ticks"
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, f"{found}, {allowed}"))
