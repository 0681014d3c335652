"""Constraint rows of a motion for joints and paths, linear in the square of its rate and in its change."""

from dataclasses import dataclass

import numpy as np

from ropsim.motion.curves.path import JointPoints
from ropsim.motion.retiming.constraint_kernel import creeping
from ropsim.motion.retiming.joint_bounds import Effort, JointBounds, torques
from ropsim.spatial import Array, frozen, record


@record
class PathMotion:
    """Motion along r paths at k nominal times, each of shape (k, r).

    With the path parameter s on a path, in its unit: the limits hold for d²s/dt² and d³s/dt³ by real time t.
    Where the motion is not on a path, s rests and its limits are infinity.

    Attributes:
        speeds: ds/dφ by nominal time φ.
        accelerations: d²s/dφ².
        most_accelerations: limits of |d²s/dt²|, above 0.
        most_jerks: limits of |d³s/dt³|, above 0.
    """

    speeds: Array
    accelerations: Array
    most_accelerations: Array
    most_jerks: Array

    def __post_init__(self) -> None:
        for name in ("speeds", "accelerations", "most_accelerations", "most_jerks"):
            object.__setattr__(self, name, frozen(getattr(self, name)))

    def with_joints(self, points: JointPoints) -> tuple[Array, Array]:
        """Return first and second derivatives of n joints and r path parameters by nominal time, (k, n + r).

        Args:
            points: the joints, k rows.
        """
        if self.speeds.shape[1] == 0:
            return np.ascontiguousarray(points.d1), np.ascontiguousarray(points.d2)
        pairs = (points.d1, self.speeds), (points.d2, self.accelerations)
        first, second = (np.ascontiguousarray(np.hstack(pair)) for pair in pairs)
        return first, second


def no_path_motion(k: int) -> PathMotion:
    """Return the record of a motion without paths of this kind at k times."""
    return PathMotion(*(np.empty((k, 0)) for _ in range(4)))


@dataclass(frozen=True, slots=True, eq=False)
class ConstraintRows:
    """Constraint rows of m grid points of a motion, n joints on r paths; u: change of rate, x: rate squared.

    The acceleration of the joints is q'·u + q''·x, and so is that on a path. Their torque is inertia·u +
    (torque of steady speed); the latter, at rest `still`, is taken as linear in x up to a speed that is
    given: exact there, for torques of gravity, dry and viscous friction and products of speeds alike.

    Attributes:
        points: the path, m grid points.
        bounds: of the joints.
        path_motion: paths with limits of their own there.
        effort: torque of the joints, or None.
        still: torque of creeping along [N m | N], shape (m, n), or (m, 0) where torque does not count.
    """

    points: JointPoints
    bounds: JointBounds
    path_motion: PathMotion
    effort: Effort | None
    still: Array

    def without_torque(self) -> "ConstraintRows":
        """Return the same where torque does not count."""
        return ConstraintRows(self.points, self.bounds, self.path_motion, None, self.points.q[:, :0])

    def along(self) -> tuple[Array, Array]:
        """Return first and second derivatives of joints and path parameters by nominal time, (m, n + r)."""
        return self.path_motion.with_joints(self.points)

    def most(self) -> Array:
        """Return the bounds of acceleration of joints and paths, (m, n + r), or (1, n) without paths."""
        return self._with_paths(self.bounds.acceleration, self.path_motion.most_accelerations)

    def most_jerk(self) -> Array:
        """Return the bounds of jerk of joints and paths, (m, n + r), or (1, n) without paths."""
        return self._with_paths(self.bounds.jerk, self.path_motion.most_jerks)

    def _with_paths(self, joints: Array, paths: Array) -> Array:
        if paths.shape[1] == 0:
            return joints[None]
        return np.ascontiguousarray(np.hstack((np.broadcast_to(joints, self.points.q.shape), paths)))

    def inertia(self) -> Array:
        """Return the torque of a unit of u [N m | N], shape (m, n), or (m, 0) where torque does not count."""
        if self.effort is None:
            return self.still
        q, d1 = self.points.q, self.points.d1
        rest = np.zeros_like(q)
        return torques(self.effort, q, rest, d1) - torques(self.effort, q, rest, rest)


def constraint_rows(
    points: JointPoints, bounds: JointBounds, effort: Effort | None, paths: PathMotion | None = None
) -> ConstraintRows:
    """Return the constraint rows of a path for the joints.

    Args:
        points: the path, m grid points.
        bounds: of the joints.
        effort: torque of the joints, or None.
        paths: paths with limits of their own there; None where there are none.

    Raises:
        ProfileError: M540, torques are no numbers.
    """
    q, d1, on = points.q, points.d1, paths or no_path_motion(len(points.q))
    if effort is None or bounds.effort is None:
        return ConstraintRows(points, bounds, on, None, q[:, :0])
    creep = np.empty(q.shape)
    creeping(np.ascontiguousarray(d1), bounds.speed, creep)
    return ConstraintRows(points, bounds, on, effort, torques(effort, q, creep, np.zeros_like(q)))
