"""Joint limits seen from a branch: its turns nearest to them, and its violations."""

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.chain.arm_arrays import turning_axes
from ropsim.kinematics.chain.arrays import joint_vector
from ropsim.kinematics.solutions.followers import follower_limits
from ropsim.kinematics.solutions.result import NO_AXIS, LimitViolation
from ropsim.kinematics.solutions.selection_kernel import LIMIT_SLACK
from ropsim.model import RobotModel
from ropsim.spatial import Array

TURN = 2.0 * np.pi


def turned_to_limits(robot: RobotModel, q: npt.ArrayLike) -> Array:
    """Return joint coordinates with each revolute joint in the turn nearest to the middle of its range.

    Args:
        robot: arm with n joints.
        q: joint coordinates [rad | m], shape (n,).
    """
    values = joint_vector(robot, q)
    with np.errstate(invalid="ignore"):  # a joint without limits has no middle
        centres = np.nan_to_num((robot.lower_limits + robot.upper_limits) / 2.0, posinf=0.0, neginf=0.0)
    turns = TURN * turning_axes(robot)
    return np.asarray(values + turns * np.round((centres - values) / TURN))


def limit_violations(robot: RobotModel, q: npt.ArrayLike) -> tuple[LimitViolation, ...]:
    """Return the joints that are outside their limits in every turn, worst first.

    Joints that follow axes by couplings or closed chains are checked in the turns of the axes nearest to
    their limits.

    Args:
        robot: arm with n joints.
        q: joint coordinates [rad | m], shape (n,), such as a row of `IkResult.branches`.
    """
    found, turned, coupled = [], turned_to_limits(robot, q), follower_limits(robot)
    numbers = (*range(robot.n), *(NO_AXIS for _ in coupled.joints))
    joints = (*robot.axis_joints, *coupled.joints)
    values = (*turned.tolist(), *coupled.values(turned).tolist())
    for index, joint, value in zip(numbers, joints, values, strict=True):
        limit = min(max(value, joint.lower), joint.upper)
        if abs(value - limit) > LIMIT_SLACK:
            found.append(LimitViolation(index, joint, value, limit))
    return tuple(sorted(found, key=lambda violation: -violation.excess))
