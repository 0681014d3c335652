"""What the joints of an arm can do for its tool: limits of tool paths that suit the arm."""

from functools import lru_cache
from itertools import product

import numpy as np

from ropsim.kinematics import configurations, frames_batch, jacobians_at, without_linear_loops
from ropsim.model import Mechanism, PathDefaults, RobotModel, held_arm
from ropsim.spatial import Array, Pose, frozen

TOOL_LENGTH = 0.15
"""Distance of the tool point from the flange along its axis [m]."""

REACH_FROM, REACH_TO = 0.4, 0.85
"""Shares of the reach from axis 2 between which the tool point of an evaluated posture is."""

HEIGHT = 0.5
"""Greatest height of the tool point above or below axis 2 in an evaluated posture over the reach."""

REGULAR = 0.05
"""Least singular value of the Jacobian over the greatest one in an evaluated posture; lengths over the
reach."""

RISE = 0.1
"""Time from no acceleration to the full one [s], so that jerk = acceleration / RISE."""

FASTEST_TURN = 8.7
"""Greatest default speed of orientation [rad/s]: 500 degrees/s, as in predefined speeds of controllers."""

SAMPLES = 512
"""Configurations of which the postures are taken."""

_FEWEST = 8
"""Fewer evaluated postures tell nothing of an arm."""
_RANK = 1e-6
"""A singular value below this share of the greatest one is 0."""
_LIES_IN = 0.5
"""A direction counts for a plane or line where its component there is at least so long."""
_CORNERS = [np.array(one, np.float64) for one in product((-1, 0, 1), repeat=3) if one > (0, 0, 0)]
_DIRECTIONS = frozen([one / np.linalg.norm(one) for one in _CORNERS])
"""Through the faces, edges and corners of a cube, one of each opposite pair, shape (13, 3)."""


def path_limits_of_joints(robot: Mechanism) -> PathDefaults | None:
    """Return limits of tool paths that the joints of an arm allow in the middle of its workspace.

    The speed is 0.25 m/s: a program states its own. The other limits are what the joints can do there: the
    tool point, `TOOL_LENGTH` in front of the flange, is accelerated along a direction while the tool keeps
    its orientation, or the tool is turned about an axis through a tool point at rest. In each posture the
    median over 13 directions counts, as far as the arm can move along them; of all postures the median;
    rounded to two digits. Limits of joints and torques hold in addition where they are lower.

    Args:
        robot: with n axes.

    Returns:
        The limits; None for a mechanism that is no arm, has closed chains other than parallelograms, or
        no such postures.
    """
    if not isinstance(robot, RobotModel) or not robot.has_arm:
        return None
    linear = without_linear_loops(robot)
    return None if linear.cuts else _of_joints(linear)


@lru_cache(maxsize=64)
def _of_joints(robot: RobotModel) -> PathDefaults | None:
    """Return the limits of an arm; None where it has too few regular postures."""
    arm = held_arm(robot).arm
    J = _regular_jacobians(arm)
    if len(J) < _FEWEST:
        return None
    linear, angular = _linear_rates(J), _angular_rates(J)
    standard = PathDefaults()
    acceleration = _median(linear, arm.max_accelerations) or standard.acceleration
    speed = _median(angular, arm.max_speeds) or standard.orientation_speed
    turning = _median(angular, arm.max_accelerations) or standard.orientation_acceleration
    return PathDefaults(
        acceleration=acceleration,
        jerk=_rounded(acceleration / RISE),
        orientation_speed=min(speed, FASTEST_TURN),
        orientation_acceleration=turning,
        orientation_jerk=_rounded(turning / RISE),
    )


def _regular_jacobians(arm: RobotModel) -> Array:
    """Return the Jacobians of the tool point at regular postures amid the workspace, shape (k, 6, n)."""
    Q = configurations(arm, SAMPLES)
    T, J = jacobians_at(arm, Q, Pose(np.array([0.0, 0.0, TOOL_LENGTH])))
    offsets = T[:, :3, 3] - _centres(arm, Q)
    distances = np.linalg.norm(offsets, axis=1)
    reach = distances.max()
    near = (distances > REACH_FROM * reach) & (distances < REACH_TO * reach)
    J = np.asarray(J[near & (np.abs(offsets[:, 2]) < HEIGHT * reach)])
    if len(J) == 0:
        return J
    sizes = np.linalg.svd(J * np.array([1.0 / reach] * 3 + [1.0] * 3)[:, None], compute_uv=False)
    rank = int((sizes > _RANK * sizes[:, :1]).sum(axis=1).max())
    found: Array = J[sizes[:, rank - 1] > REGULAR * sizes[:, 0]]
    return found


def _centres(arm: RobotModel, Q: Array) -> Array:
    """Return the points from which the reach counts, shape (k, 3) [m].

    They are on axis 2; where this axis is parallel to axis 1, as on a SCARA, on axis 1.
    """
    frames = frames_batch(arm, Q)
    first, second = (frames[:, arm.joints.index(arm.axis_joints[axis])] for axis in (0, min(1, arm.n - 1)))
    cosines = np.abs((first[:, :3, 2] * second[:, :3, 2]).sum(axis=1))
    centres: Array = np.where((cosines > 0.5)[:, None], first[:, :3, 3], second[:, :3, 3])
    return centres


def _linear_rates(J: Array) -> Array:
    """Return the joint rates for 1 m/s of the tool point along each direction, see `_rates`, (k, 13, n).

    The tool keeps its orientation; where that leaves the arm fewer directions, it turns along.
    """
    free = _free_motions(J[:, 3:])
    if _rank(J[:, :3] @ free) < _rank(J[:, :3]):
        free = _all_motions(J)
    return _rates(J[:, :3], free)


def _angular_rates(J: Array) -> Array:
    """Return the joint rates for 1 rad/s of the tool about each direction, see `_rates`, (k, 13, n).

    The tool point stands; where the arm cannot turn the tool then, it moves along.
    """
    free = _free_motions(J[:, :3])
    if _rank(J[:, 3:] @ free) == 0:
        free = _all_motions(J)
    return _rates(J[:, 3:], free)


def _rates(J: Array, free: Array) -> Array:
    """Return the joint rates for one unit along each direction, NaN where the arm cannot, shape (k, 13, n).

    Args:
        J: rows of the Jacobians in which the motion is, shape (k, 3, n).
        free: joint motions to choose from, shape (k, n, m).
    """
    motions = J @ free
    inverse = np.linalg.pinv(motions, rcond=_RANK)
    along = np.einsum("kij,dj->kdi", motions @ inverse, _DIRECTIONS)
    size = np.linalg.norm(along, axis=2, keepdims=True)
    unit = np.where(size > _LIES_IN, along / np.maximum(size, _LIES_IN), np.nan)
    rates: Array = unit @ np.swapaxes(free @ inverse, 1, 2)
    return rates


def _all_motions(J: Array) -> Array:
    return np.broadcast_to(np.eye(J.shape[2]), (len(J), J.shape[2], J.shape[2]))


def _free_motions(held: Array) -> Array:
    """Return bases of the joint motions that leave three rows of the Jacobians at 0, shape (k, n, m)."""
    _, _, V = np.linalg.svd(held, full_matrices=True)
    basis: Array = np.swapaxes(V[:, _rank(held) :], 1, 2)
    return basis


def _rank(matrices: Array) -> int:
    """Return the greatest rank of matrices (k, i, j); lengths in them are of the order of 1 m."""
    return int((np.linalg.svd(matrices, compute_uv=False) > _RANK).sum(axis=1).max(initial=0))


def _median(rates: Array, limits: Array) -> float:
    """Return the rate of the median direction in the median posture, rounded; 0 where there is none.

    Args:
        rates: of the joints for one unit, shape (k, d, n).
        limits: of the joints, shape (n,).
    """
    with np.errstate(divide="ignore"):
        reached = (limits / np.abs(rates)).min(axis=2)
    finite = [row[np.isfinite(row)] for row in reached]
    medians = [float(np.median(row)) for row in finite if len(row)]
    return _rounded(float(np.median(medians))) if medians else 0.0


def _rounded(value: float) -> float:
    return float(f"{value:.2g}")
