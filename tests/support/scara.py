"""SCARA arms for tests."""

from dataclasses import replace
from math import pi, radians

import numpy as np

from ropsim.model import DhRow, JointType, RobotModel
from ropsim.spatial import Pose
from support.wrist_arms import arm

L1, L2, HEIGHT, TRAVEL = 0.325, 0.275, 0.387, 0.210
"""Lengths of the Adept Cobra s600 [m], as in `Cobra600` of Corke's Robotics Toolbox."""


def scara() -> RobotModel:
    """Return the Cobra: two rotations, the slide pointing down, the last rotation."""
    rows = (
        DhRow(a=L1, alpha=0.0, d=HEIGHT),
        DhRow(a=L2, alpha=pi, d=0.0),
        DhRow(a=0.0, alpha=0.0, d=0.0, type=JointType.PRISMATIC),
        DhRow(a=0.0, alpha=0.0, d=0.0),
    )
    limits = ((-105.0, 105.0), (-150.0, 150.0), (0.0, TRAVEL), (-360.0, 360.0))
    robot = arm(rows)
    joints = tuple(
        replace(joint, lower=low, upper=high)
        if joint.type is JointType.PRISMATIC
        else replace(joint, lower=radians(low), upper=radians(high))
        for joint, (low, high) in zip(robot.joints, limits, strict=True)
    )
    return replace(robot, name="cobra", joints=joints)


def column() -> RobotModel:
    """Return an arm with the slide first, offsets, an axis turned over, a bent flange, a tilted base."""
    rows = (
        DhRow(a=0.05, alpha=0.0, d=0.2, theta=0.4, type=JointType.PRISMATIC),
        DhRow(a=0.4, alpha=pi, d=0.1, theta=0.3),
        DhRow(a=0.25, alpha=0.0, d=0.05, theta=-0.7),
        DhRow(a=0.1, alpha=0.5, d=0.02, theta=0.2),
    )
    tilted = Pose(np.array([0.4, -0.2, 1.0]), np.array([0.8, 0.3, -0.4, 0.1]))
    return arm(rows, tilted, Pose(np.array([0.01, 0.02, 0.03]), np.array([0.5, 0.1, 0.7, -0.2])))


def rounded() -> RobotModel:
    """Return the Cobra as a file would give it that writes π as 3.1416."""
    perfect = scara()
    rows = (perfect.dh[0], replace(perfect.dh[1], alpha=3.1416), *perfect.dh[2:])
    robot = arm(rows)
    joints = zip(robot.joints, perfect.joints, strict=True)
    limited = tuple(replace(joint, lower=one.lower, upper=one.upper) for joint, one in joints)
    return replace(robot, joints=limited)
