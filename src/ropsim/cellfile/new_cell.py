"""The cell file of a new project: a robot, a tool to be changed, and places that it reaches."""

import math
from collections.abc import Sequence

from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, Pose, frozen, quaternion

POINTER = Pose(frozen([0.0, 0.0, 0.1]))
"""The tool of a new cell: a point 100 mm in front of the mechanical interface."""

_CELL = """\
# A cell with one robot. Lengths in millimetres, angles in degrees, masses in kilograms.
# Every key is described in docs/reference/cell-file.md.

[cell]
name = "{name}"

[robot]
model = "{model}"
tool = "pointer"

# Put your tool here: its tip, its mass and its centre of mass in the mechanical interface frame.
[tools.pointer]
position = [0, 0, 100]
"""
_PLACES = "\n# Places that the robot reaches along straight lines; the tool points {how}.\n"


def new_cell(name: str, model: str, corners: Sequence[Pose]) -> str:
    """Return a cell file.

    Args:
        name: of the cell.
        model: of its robot: a built-in name, or the path of its file.
        corners: X_WT of its locations `corner_1` and so on, all with one orientation.
    """
    text = _CELL.format(name=name, model=model)
    if not corners:
        return text
    turn = _turn(corners[0])
    text += _PLACES.format(how="along the same direction at all of them" if turn else "straight down")
    for number, corner in enumerate(corners, start=1):
        x, y, z = (_number(1e3 * value, 3) for value in corner.position.tolist())
        text += f"\n[locations.corner_{number}]\nposition = [{x}, {y}, {z}]\n{turn}"
    return text


def written_coordinates(robot: RobotModel, q: Array) -> str:
    """Return joint coordinates, shape (n,), in millimetres and degrees, as cells and programs list them."""
    scales = [1e3 if joint.measure is JointType.PRISMATIC else 180.0 / math.pi for joint in robot.axis_joints]
    return ", ".join(_number(scale * value, 1) for scale, value in zip(scales, q.tolist(), strict=True))


def _turn(pose: Pose) -> str:
    """Return the line of an orientation; a tool that points straight down needs none."""
    w, x, y, z = (float(one) for one in pose.orientation)
    if abs(x) == 1.0:
        return ""
    yaw, pitch, roll = (math.degrees(angle) for angle in quaternion.to_zyx((w, x, y, z)))
    return f"rpy = [{', '.join(_number(angle, 9) for angle in (roll, pitch, yaw))}]\n"


def _number(value: float, digits: int) -> str:
    """Return a number without zeros behind it."""
    return f"{round(value, digits) + 0.0:.{digits}f}".rstrip("0").rstrip(".")
