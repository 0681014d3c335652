"""What a path asks of the joints, linear in the square of its speed and in its acceleration."""

from dataclasses import dataclass

import numpy as np

from ropsim.motion.limits.fastest_kernel import fastest
from ropsim.motion.limits.joint_bounds import Effort, JointBounds, torques
from ropsim.motion.paths.path import JointPoints
from ropsim.spatial import Array

LEAST_RATE = 1e-4
"""A path that must be gone slower than by this share of its plan cannot be gone."""
SLACK = 5e-10
"""Share by which bounds are planned wider, so that a plan that is on them is left as it is."""
_CREEP = 0.02
"""Share of the speed of joints at which dry friction is as in motion and nothing else counts."""
_PASSES = 12
_SAME = 1e-3
_MOST_AHEAD = 0.6
"""Greatest share of a change that the next one is taken to be; half of it against viscous friction alone."""


@dataclass(frozen=True, slots=True, eq=False)
class Demand:
    """What m places of a path with n joints ask; u is the acceleration along it, x the speed squared.

    The acceleration of the joints is q'·u + q''·x, their torque inertia·u + (torque of steady speed); the
    latter, at rest `still`, is taken as linear in x up to a speed that is given: exact there, for torques of
    gravity, dry friction, viscous friction and of products of speeds alike.

    Attributes:
        points: the path, m places.
        bounds: of the joints.
        effort: torque of the joints, or None.
        inertia: torque of a unit of u [N m | N], shape (m, n), or (m, 0) where torque does not count.
        still: torque of creeping along [N m | N], of the same shape.
    """

    points: JointPoints
    bounds: JointBounds
    effort: Effort | None
    inertia: Array
    still: Array

    def without_torque(self) -> "Demand":
        """Return the same where torque does not count."""
        nothing = self.points.q[:, :0]
        return Demand(self.points, self.bounds, None, nothing, nothing)

    def fastest(self, caps: Array, near: Array, steps: Array, share: Array, spared: Array) -> Array:
        """Return the greatest squared speeds x within acceleration, torque and caps, shape (m,).

        Where torque counts, they are found again with the torques at the speeds found, until these stay.

        Args:
            caps: bounds of x, shape (m,).
            near: x at which the torques are taken first, shape (m,).
            steps: ways from place to place, shape (m - 1,).
            share: what is used of the bounds of acceleration, in ]0, 1], shape (m,).
            spared: what is used of the torque that `still` leaves, in ]0, 1], shape (m,).
        """
        q, d1, d2 = self.points.q, self.points.d1, self.points.d2
        most = self.bounds.acceleration * share[:, None] * (1.0 + SLACK)
        A, B, lower, upper = np.ascontiguousarray(d1), np.ascontiguousarray(d2), -most, most
        result = np.empty(len(caps))
        if self.effort is None or self.bounds.effort is None:
            fastest(A, B, lower, upper, caps, steps, result)
            return result
        used, n = spared[:, None] * (1.0 + SLACK), q.shape[1]
        lower = np.hstack((lower, np.minimum(used * (-self.bounds.effort - self.still), 0.0)))
        upper = np.hstack((upper, np.maximum(used * (self.bounds.effort - self.still), 0.0)))
        A, B = np.hstack((A, self.inertia)), np.hstack((B, np.empty_like(q)))
        changed = np.zeros(len(caps))
        for _ in range(_PASSES):
            near = np.maximum(near, LEAST_RATE**2)
            x = near[:, None]
            B[:, n:] = (torques(self.effort, q, d1 * np.sqrt(x), d2 * x) - self.still) / x
            fastest(A, B, lower, upper, caps, steps, result)
            if np.abs(result - near).max() <= _SAME * result.max():
                break
            before, changed = changed, np.log(np.maximum(result, LEAST_RATE**2) / near)
            share = np.clip(changed / np.where(before == 0.0, np.inf, before), 0.0, _MOST_AHEAD)
            near = result * np.exp(changed * share / (1.0 - share))
        return result


def demand(points: JointPoints, bounds: JointBounds, effort: Effort | None) -> Demand:
    """Return what a path asks of the joints.

    Raises:
        ProfileError: M540, torques are no numbers.
    """
    q, d1 = points.q, points.d1
    if effort is None or bounds.effort is None:
        return Demand(points, bounds, None, q[:, :0], q[:, :0])
    rest = np.zeros_like(q)
    speeds = np.minimum(bounds.speed, np.abs(d1).max(axis=0) + np.finfo(np.float64).tiny)
    creep = _CREEP / np.maximum(np.max(np.abs(d1) / speeds, axis=1), _CREEP)
    inertia = torques(effort, q, rest, d1) - torques(effort, q, rest, rest)
    return Demand(points, bounds, effort, inertia, torques(effort, q, d1 * creep[:, None], rest))
