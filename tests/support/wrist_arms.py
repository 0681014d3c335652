"""Arms of the class with closed-form inverse kinematics, as different as the class allows."""

from math import pi

import numpy as np

from ropsim import robots
from ropsim.model import DhRow, JointLimits, RobotModel, interface_from_dh, joints_from_dh, links_from_dh
from ropsim.spatial import Pose

_LIMITS = JointLimits(-2.0 * pi, 2.0 * pi, 3.0, 10.0, 100.0)


def arm(rows: tuple[DhRow, ...], X_B0: Pose | None = None, X_6M: Pose | None = None) -> RobotModel:
    """Return a massless arm of a DH table."""
    count = len(rows)
    return RobotModel(
        name="arm",
        title="arm of a test",
        joints=joints_from_dh(rows, (_LIMITS,) * count, X_B0),
        links=links_from_dh(rows, (0.0,) * count, ((0.0,) * 3,) * count, ((0.0,) * 3,) * count),
        drives=(),
        X_nM=interface_from_dh(rows) @ (X_6M or Pose()),
        home=np.zeros(count),
        dh=rows,
    )


def industrial() -> RobotModel:
    """Return an arm with axis 2 ahead of axis 1, turning downwards, offsets, on a tilted base."""
    rows = (
        DhRow(a=0.175, alpha=-pi / 2, d=0.495, theta=0.3),
        DhRow(a=0.9, alpha=0.0, d=0.0, theta=-pi / 2),
        DhRow(a=0.175, alpha=-pi / 2, d=0.02),
        DhRow(a=0.0, alpha=pi / 2, d=0.96),
        DhRow(a=0.0, alpha=-pi / 2, d=0.0),
        DhRow(a=0.0, alpha=0.0, d=0.135, theta=pi),
    )
    tilted = Pose(np.array([0.4, -0.2, 1.0]), np.array([0.8, 0.3, -0.4, 0.1]))
    flange = Pose(np.array([0.01, 0.02, 0.03]), np.array([0.5, 0.1, 0.7, -0.2]))
    return arm(rows, tilted, flange)


def backward() -> RobotModel:
    """Return an arm with axis 2 behind axis 1, axis 3 turned against axis 2 and no lateral offset."""
    rows = (
        DhRow(a=-0.2, alpha=pi / 2, d=0.4),
        DhRow(a=0.6, alpha=pi, d=0.0, theta=0.4),
        DhRow(a=0.1, alpha=pi / 2, d=0.0),
        DhRow(a=0.0, alpha=-pi / 2, d=0.7),
        DhRow(a=0.0, alpha=pi / 2, d=0.0, theta=0.2),
        DhRow(a=0.0, alpha=0.0, d=0.1),
    )
    return arm(rows)


def all_arms() -> tuple[RobotModel, ...]:
    """Return the arms of this file and the PUMA 560."""
    return (robots.load("puma560"), industrial(), backward())
