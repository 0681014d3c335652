"""The reach of a data sheet against the table: the quickest test of all lengths together."""

import numpy as np

from ropsim.kinematics import configurations, frames_batch
from ropsim.model import JointType, RobotModel
from ropsim.robotfile.diagnostics import ANOTHER_REACH
from ropsim.spatial import Array
from ropsim.tomltext import TomlTable, Units

SLACK = 0.1
"""Share by which a data sheet may differ: sheets round, and a sampled reach is a little less."""
_SAMPLES = 1000
_WRIST = 3  # joints at whose frames a data sheet may count the reach, in addition to the interface


def check_reach(root: TomlTable, robot: RobotModel, units: Units) -> None:
    """Note a reach of the file that the arm does not have.

    Data sheets count it to the wrist centre or to the interface, from the axis of joint 1 or from where joint
    2 stands; anything between the least and the greatest of these passes.

    Args:
        root: the file, with the key `reach`.
        robot: that the file describes.
        units: of the file.
    """
    if "reach" not in root:
        return
    given = root.number("reach", units.extent, 1.0)
    if any(one.is_error for one in root.findings.items):  # the arm may have stand-ins for wrong numbers
        return
    found = _reaches(robot)
    least, most = min(found), max(found)
    if not (1.0 - SLACK) * least <= given <= (1.0 + SLACK) * most:
        quantity = units.extent
        told, low, high = (quantity.show(value / quantity.scale) for value in (given, least, most))
        message = f"`reach` is {told}; with this table the wrist comes {low} and the interface {high} far"
        hint = "compare the lengths and the form of the table with the data sheet"
        root.findings.add(ANOTHER_REACH, root.value_span("reach"), message, hint)


def _reaches(robot: RobotModel) -> list[float]:
    """Return how far wrist and interface come from the axis of joint 1, and from joint 2 [m]."""
    Q = configurations(robot, _SAMPLES)
    frames = frames_batch(robot, Q)[:, :, :3, 3]  # of the joints, then the interface
    points = [frames[:, -1 - k] for k in range(1 + min(_WRIST, robot.n))]
    found = [_from_axis(robot, point) for point in points]
    if robot.n > 1:
        found += [float(np.linalg.norm(point - frames[:, 1], axis=1).max()) for point in points]
    return [one for one in found if one > 0.0] or [0.0]


def _from_axis(robot: RobotModel, points: Array) -> float:
    """Return the greatest distance of points from the axis of joint 1, or where that slides from the base."""
    first = robot.joints[0]
    axis = first.placement.rotation()[:, 2] if first.type is JointType.REVOLUTE else np.zeros(3)
    away = points - first.placement.position
    return float(np.linalg.norm(away - np.outer(away @ axis, axis), axis=1).max())
