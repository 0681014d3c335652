"""The greatest speeds along a path, and the fastest motion under speed, acceleration and torque."""

import numpy as np

from ropsim.motion.curves.path import JointPoints
from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.retiming.constraint_rows import ConstraintRows, constraint_rows
from ropsim.motion.retiming.fastest_kernel import LinearRows, bound, fastest
from ropsim.motion.retiming.joint_bounds import Effort, JointBounds, torques
from ropsim.motion.retiming.retimed import Infeasible, too_heavy
from ropsim.motion.retiming.smooth_rates_kernel import LEAST_RATE, SLACK
from ropsim.motion.time_law.profile import ProfileError
from ropsim.spatial import Array

_PASSES = 12
_SAME = 1e-3
_MOST_AHEAD = 0.6
"""Greatest share of a change that the next one is taken to be; half of it against viscous friction alone."""


class Speeds:
    """The greatest squared speeds at the m grid points of a path of n joints and r paths.

    Args:
        requested: constraint rows of the path.
        steps: intervals from grid point to grid point, shape (m - 1,).
    """

    def __init__(self, requested: ConstraintRows, steps: Array) -> None:
        self._requested, self._steps, m = requested, steps, len(requested.points.q)
        A, B = requested.along()
        self._along, self._most = A.shape[1], requested.most()
        if requested.effort is not None:
            inertia = requested.inertia()
            A, B = np.hstack((A, inertia)), np.hstack((B, np.empty_like(inertia)))
        self._A, self._B = A, B
        self._lower, self._upper = np.empty((2, *A.shape))
        self._free, self._back, self._x = np.zeros((3, m))
        self._before, self._same = np.full((2, m), np.nan), np.empty(m)

    def under(self, imposed: Array, near: Array, share: Array, spared: Array) -> Array:
        """Return the greatest squared speeds x within acceleration, torque and caps, shape (m,).

        Where torque counts, they are found again with the torques at the speeds found, until these stay.

        Args:
            imposed: bounds of x, shape (m,).
            near: x at which the torques are taken first, shape (m,).
            share: utilisation of the bounds of acceleration, in ]0, 1], shape (m,).
            spared: utilisation of the torque that `still` leaves, in ]0, 1], shape (m,).
        """
        n, lower, upper, requested = self._along, self._lower, self._upper, self._requested
        bound(self._most, share, imposed, 1.0 + SLACK, self._before, lower, upper, self._same)
        if requested.effort is None or requested.bounds.effort is None:
            return self._fastest(imposed)
        used, still, B = spared[:, None] * (1.0 + SLACK), requested.still, self._B
        lower[:, n:] = np.minimum(used * (-requested.bounds.effort - still), 0.0)
        upper[:, n:] = np.maximum(used * (requested.bounds.effort - still), 0.0)
        q, d1, d2 = requested.points.q, requested.points.d1, requested.points.d2
        changed, result = np.zeros(len(imposed)), near
        for _ in range(_PASSES):
            near = np.maximum(near, LEAST_RATE**2)
            x = near[:, None]
            B[:, n:] = (torques(requested.effort, q, d1 * np.sqrt(x), d2 * x) - still) / x
            self._same[:] = 0.0
            result = self._fastest(imposed)
            if np.abs(result - near).max() <= _SAME * result.max():
                break
            before, changed = changed, np.log(np.maximum(result, LEAST_RATE**2) / near)
            share = np.clip(changed / np.where(before == 0.0, np.inf, before), 0.0, _MOST_AHEAD)
            near = result * np.exp(changed * share / (1.0 - share))
        return result

    def _fastest(self, imposed: Array) -> Array:
        rows = LinearRows(self._A, self._B, self._lower, self._upper)
        fastest(rows, imposed, self._steps, self._same, self._free, self._back, self._x)
        return self._x.copy()


_FASTEST = 1e6
_TINY = 1e-12


def time_optimal(
    points: JointPoints, step: float, bounds: JointBounds, effort: Effort | None
) -> Array | Infeasible:
    """Return the speeds ds/dt of the fastest motion along a path, from rest to rest, shape (m,).

    Args:
        points: the path on a grid of its parameter s, m >= 2 grid points, and its derivatives by s.
        step: of the grid.
        bounds: of the joints; jerk is ignored.
        effort: torques at the joints, affine in accelerations; None where they do not count.

    Returns:
        the speeds, or the first grid point at which the arm cannot even creep (its `phi` is the s of the grid
        point).

    Raises:
        ProfileError: M540, the grid is none, or the path or its torques are no numbers.
    """
    m = len(points.q)
    finite = all(bool(np.isfinite(each).all()) for each in (points.q, points.d1, points.d2))
    if m < 2 or not 0.0 < step < np.inf or not finite:
        found = f"a path of {m} places with steps of {step:g}"
        message = f"{found}, allowed are finite numbers at 2 places or more"
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, message))
    requested = constraint_rows(points, bounds, effort)
    refusal = too_heavy(requested, np.asarray(np.arange(m) * step, dtype=np.float64))
    if refusal is not None:
        return refusal
    imposed = 1.0 / np.maximum(np.max(np.abs(points.d1) / bounds.speed, axis=1), 1.0 / _FASTEST) ** 2
    imposed[0] = imposed[-1] = 0.0
    x = np.minimum(imposed, 1.0 / np.maximum(np.max(np.abs(points.d2) / bounds.acceleration, axis=1), _TINY))
    everything = np.ones(m)
    return np.asarray(
        np.sqrt(Speeds(requested, np.full(m - 1, step)).under(imposed, x, everything, everything))
    )
