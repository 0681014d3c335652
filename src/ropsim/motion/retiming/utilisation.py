"""Utilisation of the limits by a motion, at control ticks."""

from dataclasses import dataclass

import numpy as np

from ropsim.motion.curves.path import JointPoints
from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.retiming.constraint_rows import PathMotion, no_path_motion
from ropsim.motion.retiming.joint_bounds import JointBounds, no_torques
from ropsim.motion.retiming.path_load_kernel import PathLoad
from ropsim.motion.retiming.utilisation_kernel import (
    AT_ONCE,
    ROWS_OF_MOTION,
    ROWS_OF_TORQUE,
    TORQUE,
    Derivatives,
    Grid,
    JointLoad,
    Used,
    used_by_motion,
    used_by_torque,
    utilisation_of,
)
from ropsim.motion.time_law.profile import ProfileError
from ropsim.spatial import Array

ROUNDING = 1e-9
"""More than a bound by this share of it is rounding."""


@dataclass(frozen=True, slots=True, eq=False)
class Going:
    """Rate of a path and its changes at k control ticks.

    Attributes:
        points: the joints by nominal time, k rows.
        path_motion: paths with separate limits, at the same ticks.
        timing: nominal times [s], rates, and changes of these [1/s], shape (3, k).
        grid_phi: nominal times between which excesses are expressed [s], rising, shape (m,).
        still: torque of creeping there [N m | N], shape (m, n), or (m, 0) where torque does not count.
    """

    points: JointPoints
    path_motion: PathMotion
    timing: Array
    grid_phi: Array
    still: Array


@dataclass(frozen=True, slots=True, eq=False)
class Utilisation:
    """Utilisation of the limits at k control ticks.

    Attributes:
        used: by the joint or path that uses most, 1.0 for all of it, in the order of `Quantity`, (4, k).
        peaks: the most of each, shape (4,); where torque is too much, of that alone which slowing changes.
        lacks: logarithms of divisors of rate and acceleration, multipliers of windows, and divisors of
            torque, at m grid points, shape (4, m).
    """

    used: Array
    peaks: Array
    lacks: Array

    @property
    def is_within_limits(self) -> bool:
        """Return whether no limit is exceeded but by rounding."""
        most = 1.0 + ROUNDING
        return bool(self.peaks[:TORQUE].max() <= most and self.used[TORQUE].max() <= most)

    @property
    def rates(self) -> Array:
        """Return the rate at each tick at which limits would about hold, in ]0, 1], shape (k,)."""
        speed, acceleration, jerk, _ = self.used
        needed = np.maximum(speed, np.maximum(np.sqrt(acceleration), np.cbrt(jerk)))
        return np.asarray(1.0 / np.maximum(needed, 1.0))

    @property
    def factor(self) -> float:
        """Return by how much the whole motion must be slower to keep all here, from 1.0 on."""
        speed, acceleration, jerk, torque = self.peaks.tolist()
        return float(max(speed, np.sqrt(acceleration), np.cbrt(jerk), np.sqrt(torque), 1.0))


def utilisation_as_planned(rows: JointPoints, bounds: JointBounds, period: float) -> Utilisation:
    """Return the utilisation of the bounds by unslowed rows, except torque; without excesses.

    Args:
        rows: references at the control ticks, k rows.
        bounds: of the joints.
        period: of the control ticks [s].

    Raises:
        ProfileError: M540, references are no numbers.
    """
    limits = np.array([bounds.speed, bounds.acceleration, period * bounds.jerk])
    k, n = rows.q.shape
    used, peaks, work = np.empty((4, k)), np.zeros(4), np.empty((ROWS_OF_MOTION, AT_ONCE * n))
    used[TORQUE] = 0.0
    used_by_motion(rows.d1.reshape(-1), rows.d2.reshape(-1), limits, work, used, peaks)
    return _without_excess(rows, used, peaks)


def with_torque(plain: Utilisation, rows: JointPoints, torque: Array, bounds: JointBounds) -> Utilisation:
    """Return the utilisation by the same rows with their torques.

    Args:
        plain: their utilisation except torque.
        rows: references at the control ticks, k rows.
        torque: of the joints there [N m | N], shape (k, n).
        bounds: of the joints.

    Raises:
        ProfileError: M540, torques are no numbers.
    """
    assert bounds.effort is not None
    used, peaks = plain.used.copy(), plain.peaks.copy()
    work = np.empty((ROWS_OF_TORQUE, AT_ONCE * torque.shape[1]))
    used_by_torque(torque.reshape(-1), bounds.effort, work, used, peaks)
    if not peaks[TORQUE] < np.inf and not np.isfinite(torque).all():
        raise no_torques(torque, rows.q)
    return _without_excess(rows, used, peaks)


def _without_excess(rows: JointPoints, used: Array, peaks: Array) -> Utilisation:
    if not peaks.max() < np.inf:
        _check(rows, used)
    return Utilisation(used, peaks, np.zeros((len(used), 2)))


def _check(rows: JointPoints, used: Array) -> None:
    if not used.max() < np.inf:
        row = int(np.flatnonzero(~(used < np.inf).all(axis=0))[0])
        found = f"the motion is {rows.q[row]}, {rows.d1[row]}, {rows.d2[row]} at tick {row}"
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, f"{found}, allowed are finite numbers"))


def utilisation_of_rows(
    rows: JointPoints,
    torque: Array | None,
    bounds: JointBounds,
    period: float,
    going: Going | None = None,
    more: float = 0.0,
) -> Utilisation:
    """Return the utilisation of the bounds by rows; see `utilisation_of`.

    Args:
        rows: references at the control ticks, k rows.
        torque: of the joints there [N m | N], shape (k, n), or None where it does not count.
        bounds: of the joints.
        period: of the control ticks [s].
        going: rate of the path; None for the planned one.
        more: added to each lack.

    Raises:
        ProfileError: M540, references are no numbers.
    """
    k = len(rows.q)
    if torque is None or bounds.effort is None:
        torque = np.empty((k, 0))
    if going is None:
        ends, still = np.array([0.0, np.inf]), np.zeros((2, torque.shape[1]))
        going = Going(rows, no_path_motion(k), np.stack((np.zeros(k), np.ones(k), np.zeros(k))), ends, still)
    used, peaks, lacks = np.zeros((4, k)), np.zeros(4), np.zeros((4, len(going.grid_phi)))
    load = JointLoad(np.ascontiguousarray(rows.d1), np.ascontiguousarray(rows.d2), torque)
    joints = Derivatives(np.ascontiguousarray(going.points.d1), np.ascontiguousarray(going.points.d2))
    own = going.path_motion
    paths = PathLoad(own.speeds, own.accelerations, own.most_accelerations, own.most_jerks)
    grid, out = Grid(going.grid_phi, going.still), Used(used, peaks, lacks)
    allowed = 1.0 + ROUNDING
    utilisation_of(
        load, joints, paths, going.timing, grid, _limits(bounds, period), period, allowed, more, out
    )
    _check(rows, used)
    return Utilisation(used, peaks, lacks)


def _limits(bounds: JointBounds, period: float) -> Array:
    """Return the limits of n joints, and their inverses, shape (2, 4, n).

    They are in the order of speed, acceleration, change of acceleration in one tick, and torque.
    """
    effort = np.full(len(bounds.speed), np.inf) if bounds.effort is None else bounds.effort
    limits = np.array([bounds.speed, bounds.acceleration, period * bounds.jerk, effort])
    return np.stack((limits, 1.0 / limits))
