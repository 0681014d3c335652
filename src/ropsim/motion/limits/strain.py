"""What a motion uses of the limits, at control ticks."""

from dataclasses import dataclass

import numpy as np

from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.limits.joint_bounds import JointBounds
from ropsim.motion.limits.strain_kernel import strain_of
from ropsim.motion.paths.path import JointPoints
from ropsim.motion.profile import ProfileError
from ropsim.spatial import Array

ROUNDING = 1e-9
"""More than a bound by this share of it is rounding."""


@dataclass(frozen=True, slots=True, eq=False)
class Going:
    """How a path is gone at k control ticks.

    Attributes:
        path: first and second derivatives of the joints by motion time, shape (2, k, n).
        course: motion times [s], rates, and changes of these [1/s], shape (3, k).
        places: motion times between which lacks are told [s], rising, shape (m,).
        still: torque of creeping there [N m | N], shape (m, n), or (m, 0) where torque does not count.
    """

    path: Array
    course: Array
    places: Array
    still: Array


@dataclass(frozen=True, slots=True, eq=False)
class Strain:
    """What is used of the limits at k control ticks.

    Attributes:
        used: by the joint that uses most, 1.0 for all of it, in the order of `Quantity`, shape (4, k).
        peaks: the most of each, shape (4,); where torque is too much, of that alone which slowing changes.
        lacks: logarithms of what rate and acceleration are to be divided by, windows to be multiplied with,
            and torque to be divided by, at m places, shape (4, m).
    """

    used: Array
    peaks: Array
    lacks: Array

    @property
    def is_kept(self) -> bool:
        """Return whether no limit is exceeded but by rounding."""
        return bool(self.used.max() <= 1.0 + ROUNDING)

    @property
    def factor(self) -> float:
        """Return by how much the whole motion must be slower to keep all here, from 1.0 on."""
        speed, acceleration, jerk, torque = self.peaks.tolist()
        return float(max(speed, np.sqrt(acceleration), np.cbrt(jerk), np.sqrt(torque), 1.0))


def strain(
    rows: JointPoints,
    torque: Array | None,
    bounds: JointBounds,
    period: float,
    going: Going | None = None,
    more: float = 0.0,
) -> Strain:
    """Return what rows use of the bounds; see `strain_of`.

    Args:
        rows: references at the control ticks, k rows.
        torque: of the joints there [N m | N], shape (k, n), or None where it does not count.
        bounds: of the joints.
        period: of the control ticks [s].
        going: how the path is gone; None for as it is planned.
        more: added to each lack.

    Raises:
        ProfileError: M540, references are no numbers.
    """
    k, n = rows.q.shape
    qd, qdd = np.ascontiguousarray(rows.d1), np.ascontiguousarray(rows.d2)
    if torque is None or bounds.effort is None:
        torque = np.empty((k, 0))
    if going is None:
        ends, still = np.array([0.0, np.inf]), np.zeros((2, torque.shape[1]))
        going = Going(np.stack((qd, qdd)), np.stack((np.zeros(k), np.ones(k), np.zeros(k))), ends, still)
    effort = np.full(n, np.inf) if bounds.effort is None else bounds.effort
    limits = np.array([bounds.speed, bounds.acceleration, period * bounds.jerk, effort])
    used, peaks, lacks = np.zeros((4, k)), np.zeros(4), np.zeros((4, len(going.places)))
    strain_of(
        qd,
        qdd,
        torque,
        going.path,
        going.course,
        going.places,
        going.still,
        limits,
        1.0 + ROUNDING,
        more,
        used,
        peaks,
        lacks,
    )
    if not used.max() < np.inf:
        row = int(np.flatnonzero(~(used < np.inf).all(axis=0))[0])
        found = f"the motion is {rows.q[row]}, {rows.d1[row]}, {rows.d2[row]} at tick {row}"
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, f"{found}, allowed are finite numbers"))
    return Strain(used, peaks, lacks)
