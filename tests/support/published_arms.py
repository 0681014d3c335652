"""Arms of other makers as their published files describe them: chains only, without masses and drives."""

import tomllib
from math import pi
from pathlib import Path
from typing import Any

import numpy as np

from ropsim.model import Joint, JointType, Link, RobotModel
from ropsim.spatial import Array, Pose

DATA = Path(__file__).parents[1] / "reference" / "data"
TABLES: dict[str, Any] = tomllib.loads((DATA / "published_arms.toml").read_text(encoding="utf-8"))
SEVEN_AXES: dict[str, Any] = tomllib.loads((DATA / "seven_axis_arms.toml").read_text(encoding="utf-8"))
FIVE_AXES: dict[str, Any] = tomllib.loads((DATA / "five_axis_arms.toml").read_text(encoding="utf-8"))


def published_arm(name: str) -> RobotModel:
    """Return an arm of the files; its mechanical interface is the tip."""
    table = (TABLES | SEVEN_AXES | FIVE_AXES)[name]
    before = _frame(table["base"]) if "base" in table else np.eye(4)
    joints = []
    for number, row in enumerate(table["joints"], start=1):
        turned = _aligned(np.array(row[6:9]))
        placement = Pose.from_matrix(before @ _frame(row[:6]) @ turned)
        lower, upper = row[9:]
        joints.append(Joint(str(number), JointType.REVOLUTE, placement, 0.0, lower, upper, 3.0, 10.0, 100.0))
        before = turned.T  # back to the axes of the file
    for row in table["tip"]:
        before = before @ _frame(row)
    massless = Link(0.0, np.zeros(3), np.zeros((3, 3)))
    n = len(joints)
    X_nM = Pose.from_matrix(before)
    return RobotModel(name, name, tuple(joints), (massless,) * n, (), np.zeros(n), X_nM=X_nM)


def random_joints(robot: RobotModel, count: int, seed: int) -> Array:
    """Return configurations within the limits, each joint within half a turn of zero, shape (count, n)."""
    lower, upper = np.maximum(robot.lower_limits, -pi), np.minimum(robot.upper_limits, pi)
    return np.random.default_rng(seed).uniform(lower, upper, (count, robot.n))


def _frame(row: list[float]) -> Array:
    """Return the matrix of x, y, z, roll, pitch, yaw, shape (4, 4)."""
    (sr, sp, sy), (cr, cp, cy) = np.sin(row[3:]), np.cos(row[3:])
    X = np.eye(4)
    X[:3, :3] = (
        np.array([[cy, -sy, 0.0], [sy, cy, 0.0], [0.0, 0.0, 1.0]])
        @ np.array([[cp, 0.0, sp], [0.0, 1.0, 0.0], [-sp, 0.0, cp]])
        @ np.array([[1.0, 0.0, 0.0], [0.0, cr, -sr], [0.0, sr, cr]])
    )
    X[:3, 3] = row[:3]
    return X


def _aligned(axis: Array) -> Array:
    """Return a rotation whose z is a coordinate axis or its opposite, shape (4, 4)."""
    place = int(np.argmax(np.abs(axis)))
    X = np.eye(4)
    X[:3, 2] = axis
    X[:3, 0] = np.eye(3)[(place + 1) % 3]
    X[:3, 1] = np.cross(X[:3, 2], X[:3, 0])
    return X
