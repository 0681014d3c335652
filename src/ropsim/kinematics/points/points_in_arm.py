"""Points and joint coordinates of a robot as those of its arm, which external axes may carry."""

import numpy as np

from ropsim.kinematics.chain.arm_arrays import interface_poses
from ropsim.kinematics.points.point_arm import PointShape
from ropsim.kinematics.solutions.held import in_arm_base, of_robot
from ropsim.model import RobotModel, held_arm
from ropsim.spatial import Array


def of_arm(robot: RobotModel, q: Array) -> Array:
    """Return the coordinates of the arm alone, shape (..., axes of the arm)."""
    return np.ascontiguousarray(q[..., list(held_arm(robot).axes)]) if robot.external else q


def of_whole(robot: RobotModel, held: Array, q: Array) -> Array:
    """Return the coordinates of all axes for rows of the arm; external ones as `held` has them."""
    return of_robot(held_arm(robot), held, q) if robot.external else np.asarray(q)


def points_in_arm(robot: RobotModel, points: Array, held: Array) -> Array:
    """Return points (k, 3) in the base frame of the robot as points in that of its arm [m].

    Args:
        robot: with its external axes.
        points: [m].
        held: coordinates of the axes, of which only the external ones count, shape (n,) or (k, n).
    """
    if not robot.external:
        return np.ascontiguousarray(points)
    T = np.zeros((len(points), 4, 4))
    T[:] = np.eye(4)
    T[:, :3, 3] = points
    return np.ascontiguousarray(in_arm_base(robot, held_arm(robot), held, T)[:, :3, 3])


def tcp_of(shape: PointShape, q: Array) -> Array:
    """Return where the TCP is in the base frame of the arm at its coordinates (n,) [m], shape (3,)."""
    X_BM = interface_poses(shape.chain, q[np.newaxis])[0]
    return np.asarray(X_BM[:3, :3] @ shape.tcp + X_BM[:3, 3])
