"""A robot with other speed, acceleration and jerk limits of its axes."""

from dataclasses import replace

from ropsim.model.robot import RobotModel
from ropsim.spatial import Array


def with_axis_limits(robot: RobotModel, speed: Array, acceleration: Array, jerk: Array) -> RobotModel:
    """Return a robot whose axes have these limits; the robot itself where they are its own.

    Args:
        robot: n axes.
        speed: [rad/s | m/s], shape (n,).
        acceleration: [rad/s² | m/s²], shape (n,).
        jerk: [rad/s³ | m/s³], shape (n,).
    """
    joints = list(robot.joints)
    for number, v, a, j in zip(robot.axes, speed, acceleration, jerk, strict=True):
        joints[number] = replace(
            joints[number], max_speed=float(v), max_acceleration=float(a), max_jerk=float(j)
        )
    return robot if tuple(joints) == robot.joints else replace(robot, joints=tuple(joints))
