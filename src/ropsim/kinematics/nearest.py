"""The pose that comes nearest to one that an arm cannot take."""

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.chain.arm_arrays import arm_arrays, interface_poses
from ropsim.kinematics.chain.arrays import joint_vector
from ropsim.kinematics.diagnostics import NotFiniteError
from ropsim.kinematics.solutions.configurations import configurations
from ropsim.kinematics.solutions.held import in_arm_base, of_robot
from ropsim.kinematics.solutions.limits import limit_violations, turned_to_limits
from ropsim.kinematics.solutions.polish import nearest_to
from ropsim.kinematics.solvers.axes import angle_of_turn
from ropsim.model import RobotModel, held_arm
from ropsim.spatial import Array, Pose, record

STARTS = 64
"""Starts of the search, which fill the range of the joints evenly."""


@record
class Nearest:
    """A pose that an arm can take, near a requested one.

    Attributes:
        q: joint coordinates that take it, within the limits where the search found any there [rad | m], shape
            (n,).
        pose: X_BM of the mechanical interface.
        distance: between the two positions [m].
        angle: between the two orientations [rad].
    """

    q: Array
    pose: Pose
    distance: float
    angle: float


def nearest(robot: RobotModel, pose: Pose, near: npt.ArrayLike | None = None) -> Nearest:
    """Return the pose nearest to a requested one, found numerically from many starts.

    A metre between positions counts as much as a radian between orientations. External axes stay where `near`
    has them. Poses within the limits are preferred; there may be a nearer one that was not found.

    Args:
        robot: arm with n joints.
        pose: X_BM.
        near: joint coordinates [rad | m] of a further start, shape (n,); None for the home position.

    Raises:
        ArrayShapeError: M551, `near` has another shape.
        NotFiniteError: M552, the pose or `near` holds NaN or infinity.
    """
    q = robot.home if near is None else joint_vector(robot, near)
    T = pose.matrix()
    if not np.isfinite(T).all():
        raise NotFiniteError("pose")
    if not robot.external:
        return _of_arm(robot, T, q)
    whole = held_arm(robot)
    found = _of_arm(whole.arm, in_arm_base(robot, whole, q, T[np.newaxis])[0], q[list(whole.axes)])
    X = in_arm_base(robot, whole, q, np.eye(4)[np.newaxis])[0]
    back = Pose.from_matrix(X).inverse() @ found.pose
    return Nearest(of_robot(whole, q, found.q), back, found.distance, found.angle)


def _of_arm(robot: RobotModel, T: Array, q: Array) -> Nearest:
    """Return `nearest` of an arm without external axes."""
    chain = arm_arrays(robot)
    starts = np.concatenate((q[np.newaxis], configurations(robot, STARTS)))
    ends = nearest_to(chain, T[np.newaxis], starts[np.newaxis])[0]
    poses = interface_poses(chain, ends)
    distances = np.linalg.norm(poses[:, :3, 3] - T[:3, 3], axis=1)
    angles = np.array([angle_of_turn(one, T) for one in poses])
    order = np.argsort(np.hypot(distances, angles), kind="stable")
    best = next((k for k in order if not limit_violations(robot, ends[k])), order[0])
    turned = turned_to_limits(robot, ends[best])
    return Nearest(turned, Pose.from_matrix(poses[best]), float(distances[best]), float(angles[best]))
