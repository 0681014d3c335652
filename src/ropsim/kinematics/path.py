"""Inverse kinematics along a path, from a known neighbour: the pose before, or a guess for each."""

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.chain.arm_arrays import arm_arrays
from ropsim.kinematics.chain.arrays import joint_rows, joint_vector, pose_rows
from ropsim.kinematics.recognition import solver_of
from ropsim.kinematics.solutions.held import in_arm_base, of_robot
from ropsim.kinematics.solutions.polish import continued, polished
from ropsim.model import RobotModel, held_arm
from ropsim.spatial import Array

_TURN = 2.0 * np.pi


def inverse_path(
    robot: RobotModel, T: npt.ArrayLike, q_start: npt.ArrayLike, held: npt.ArrayLike | None = None
) -> Array:
    """Return joint coordinates along a path, each found numerically from the one before it; for any arm.

    External axes stay where they are at the start, or go where they are held at each pose.

    Args:
        robot: arm with n joints.
        T: poses X_BM along the path, one a small step from the other, shape (k, 4, 4).
        q_start: joint coordinates one step before the first pose [rad | m], shape (n,).
        held: coordinates of the axes at each pose, of which only the external ones count [rad | m], shape (k,
            n); None for the values of `q_start`.

    Returns:
        Joint coordinates [rad | m] without whole turns between them, shape (k, n); NaN from the first pose
        on that is not reached.

    Raises:
        ArrayShapeError: M551, T, `q_start` or `held` has another shape.
        NotFiniteError: M552, `q_start` holds NaN or infinity.
    """
    if robot.external:
        whole, q = held_arm(robot), joint_vector(robot, q_start)
        rows = q if held is None else joint_rows(robot, held)
        poses = in_arm_base(robot, whole, rows, pose_rows(T))
        return of_robot(whole, rows, inverse_path(whole.arm, poses, q[list(whole.axes)]))
    return continued(arm_arrays(robot), pose_rows(T), joint_vector(robot, q_start), solver_of(robot).slack)


def inverse_near(robot: RobotModel, T: npt.ArrayLike, Q: npt.ArrayLike) -> Array:
    """Return joint coordinates that reach poses, each found numerically from a guess; for any arm.

    External axes are where the guesses have them.

    Args:
        robot: arm with n joints.
        T: poses X_BM, shape (k, 4, 4).
        Q: guesses near to the answers [rad | m], shape (k, n).

    Returns:
        Joint coordinates [rad | m] without whole turns to the guesses, shape (k, n); NaN where a pose is not
        reached.

    Raises:
        ArrayShapeError: M551, T or Q has another shape.
    """
    rows = joint_rows(robot, Q)
    if robot.external:
        whole = held_arm(robot)
        poses = in_arm_base(robot, whole, rows, pose_rows(T))
        return of_robot(whole, rows, inverse_near(whole.arm, poses, rows[:, list(whole.axes)]))
    chain = arm_arrays(robot)
    found = polished(chain, pose_rows(T), rows[:, None].copy(), solver_of(robot).slack)[:, 0]
    return np.asarray(found + _TURN * np.round((rows - found) / _TURN) * chain.turning)
