"""References at control ticks, and what they use of the limits."""

from dataclasses import dataclass

import numpy as np

from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.limits.demand import Demand
from ropsim.motion.limits.joint_bounds import Effort, JointBounds, torques
from ropsim.motion.limits.kept import Motion
from ropsim.motion.limits.motion_time import MotionTime
from ropsim.motion.paths.path import JointPoints
from ropsim.motion.profile import ProfileError, whole_periods
from ropsim.spatial import Array

ROUNDING = 1e-9
"""More than a bound by this share of it is rounding."""
_TINY = 1e-300


@dataclass(frozen=True, slots=True, eq=False)
class Reference:
    """A slowed motion at k control ticks.

    Attributes:
        phi: motion times [s], shape (k,).
        rows: coordinates, speeds and accelerations by real time.
        worst: the most that is used of any bound, 1.0 for all of it.
        excess: what is used of the bounds, 1.0 for all, in the order of `Quantity`, shape (4, k, n);
            where torque is too much, of that alone which slowing changes.
        jerk_causes: share that the path, changes of rate on a bent path and changes of acceleration along the
            path have in the jerk, shape (3, k, n).
    """

    phi: Array
    rows: JointPoints
    worst: float
    excess: Array
    jerk_causes: Array

    @property
    def factor(self) -> float:
        """Return by how much the whole motion must be slower to keep all here, from 1.0 on."""
        speed, acceleration, jerk, torque = self.excess.max(axis=(1, 2))
        return float(max(speed, np.sqrt(acceleration), np.cbrt(jerk), np.sqrt(torque), 1.0))


def tick_times(duration: float, period: float) -> Array:
    """Return the control ticks [s] from 0 on, the last one at or behind the end, shape (k,)."""
    return np.asarray(np.arange(whole_periods(duration, period) + 1) * period, dtype=np.float64)


def strains(rows: JointPoints, torque: Array | None, bounds: JointBounds, period: float) -> Array:
    """Return what is used of the bounds, 1.0 for all, in the order of `Quantity`, shape (4, k, n).

    Jerk is the difference of accelerations of neighbouring ticks, at the later one of the two; joints rest
    before the first and after the last tick.

    Args:
        rows: references at the control ticks, k rows.
        torque: of the joints there [N m | N], shape (k, n), or None where it does not count.
        bounds: of the joints.
        period: of the control ticks [s].

    Raises:
        ProfileError: M540, references are no numbers.
    """
    result = np.zeros((4, *rows.q.shape))
    np.abs(rows.d1, out=result[0])
    np.abs(rows.d2, out=result[1])
    np.subtract(rows.d2[1:], rows.d2[:-1], out=result[2, 1:])
    result[2, 0] = rows.d2[0]
    np.abs(result[2], out=result[2])
    np.maximum(result[2, -1], result[1, -1], out=result[2, -1])
    result[0] /= bounds.speed
    result[1] /= bounds.acceleration
    result[2] /= period * bounds.jerk
    if torque is not None and bounds.effort is not None:
        np.divide(np.abs(torque), bounds.effort, out=result[3])
    if not np.isfinite(result.max()):
        row = int(np.flatnonzero(~np.isfinite(result).all(axis=(0, 2)))[0])
        found = f"the motion is {rows.q[row]}, {rows.d1[row]}, {rows.d2[row]} at tick {row}"
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, f"{found}, allowed are finite numbers"))
    return result


def load(rows: JointPoints, bounds: JointBounds, effort: Effort | None) -> Array | None:
    """Return the torques of rows [N m | N], shape (k, n), or None where torque does not count."""
    counts = effort is not None and bounds.effort is not None
    return torques(effort, rows.q, rows.d1, rows.d2) if counts and effort else None


def reference(motion: Motion, clock: MotionTime, demand: Demand, places: Array, period: float) -> Reference:
    """Return the references of a motion in its motion time.

    qd = q'·w and qdd = q''·w² + q'·c, with the rate w of motion time and its change c.

    Args:
        motion: the plan.
        clock: its motion time.
        demand: what it asks of the joints at the places.
        places: motion times [s], shape (m,).
        period: of the control ticks [s].

    Raises:
        ProfileError: M540, as for `strains`.
    """
    phi, rates, changes = clock.at(tick_times(clock.duration, period))
    points, w, c = motion.at(phi), rates[:, None], changes[:, None]
    rows = JointPoints(points.q, points.d1 * w, points.d2 * w**2 + points.d1 * c)
    torque = load(rows, demand.bounds, demand.effort)
    excess = strains(rows, torque, demand.bounds, period)
    worst = float(excess.max())
    if torque is not None and demand.bounds.effort is not None:
        still = np.column_stack([np.interp(phi, places, each) for each in demand.still.T])
        held = still * np.sign(torque)
        room = np.maximum(demand.bounds.effort - held, _TINY)
        excess[3] = np.where(excess[3] > 1.0 + ROUNDING, (np.abs(torque) - held) / room, excess[3])
    path = np.abs(_steps(points.d2)) * w**2
    bend = np.abs(points.d2 * _steps(w**2)) + np.abs(_steps(points.d1) * c)
    change = np.abs(points.d1 * _steps(c))
    parts = np.stack((path, bend, change))
    return Reference(phi, rows, worst, excess, parts / np.maximum(parts.sum(axis=0), _TINY))


def _steps(values: Array) -> Array:
    """Return the differences of neighbouring rows, 0 in the first row."""
    return np.diff(values, axis=0, prepend=values[:1])
