"""References at control ticks, and their utilisation of the limits."""

import math
from dataclasses import dataclass

import numpy as np

from ropsim.core import keep_freed_memory
from ropsim.motion.curves.path import JointPoints
from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.retiming.joint_bounds import Effort, JointBounds, Ticks, checked_torques
from ropsim.motion.retiming.retimed import Motion
from ropsim.motion.retiming.utilisation import Utilisation, utilisation_as_planned, with_torque
from ropsim.motion.time_law.profile import ProfileError
from ropsim.spatial import Array

_MOST_TICKS = 1e8


@dataclass(frozen=True, slots=True, eq=False)
class Reference:
    """A motion at k control ticks.

    Attributes:
        phi: nominal times [s], shape (k,).
        rows: coordinates, speeds and accelerations by real time.
        torque: that they take [N m | N], shape (k, n); None where it does not count.
        utilisation: utilisation of the limits.
    """

    phi: Array
    rows: JointPoints
    torque: Array | None
    utilisation: Utilisation


def as_planned(motion: Motion, bounds: JointBounds, effort: Effort | None, ticks: Ticks) -> Reference:
    """Return the references of a motion that is not slowed.

    Args:
        motion: the plan, at rest at both ends.
        bounds: capabilities of the joints.
        effort: torques at the joints; None where they do not count.
        ticks: at which it is evaluated.

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
    return loaded(
        Reference(phi, rows, None, utilisation_as_planned(rows, bounds, ticks.period)), bounds, effort
    )


def loaded(planned: Reference, bounds: JointBounds, effort: Effort | None) -> Reference:
    """Return references that are not slowed with the torques that they take.

    Args:
        planned: the references, without torques.
        bounds: capabilities of the joints.
        effort: torques at the joints; None where they do not count.

    Raises:
        ProfileError: M540, torques are no numbers.
    """
    rows = planned.rows
    if effort is None or bounds.effort is None:
        return planned
    torque = checked_torques(effort, rows.q, rows.d1, rows.d2)
    return Reference(planned.phi, rows, torque, with_torque(planned.utilisation, rows, torque, bounds))


def _check(duration: float, period: float) -> None:
    numbers = (duration, period)
    if not all(math.isfinite(each) and each > 0.0 for each in numbers) or duration / period > _MOST_TICKS:
        found = f"duration is {duration:g} s, control tick {period:g} s"
        allowed = f"allowed are numbers above 0, and {_MOST_TICKS:g} ticks"
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, f"{found}, {allowed}"))
