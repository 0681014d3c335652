"""The recorded channels: units, names and meaning."""

from collections.abc import Mapping, Sequence

import numpy as np

from ropsim.dynamics import Column, structure_of
from ropsim.flow import Channel
from ropsim.model import Joint, JointType, RobotModel
from ropsim.simulation.servo.log import ARM_COLUMNS, REFERENCE_COLUMNS, LogLayout, recorded
from ropsim.spatial import Array, quaternions_from_matrices

_ERROR = Column("q_error", "{q}", "reference minus attained joint coordinates")
_COORDINATE = {JointType.REVOLUTE: "rad", JointType.PRISMATIC: "m"}
_EFFORT = {JointType.REVOLUTE: "N·m", JointType.PRISMATIC: "N"}


def joint_channels(robot: RobotModel, log: Mapping[str, Array]) -> dict[str, Channel]:
    """Return the channels of the joints that a log holds.

    Args:
        robot: names and types of the joints.
        log: arrays by channel name, a column for each joint that has the quantity; other names are left out.
    """
    chains = structure_of(robot).drives
    drives = dict.fromkeys(column for chain in chains for column in recorded(chain))
    axes = {field.name: field.axes for field in LogLayout.of(chains).fields}
    channels = {}
    for column in (*ARM_COLUMNS, *drives, *REFERENCE_COLUMNS, _ERROR):
        if column.name in log:
            joints = [robot.axis_joints[k] for k in axes.get(column.name, range(robot.n))]
            values = np.asarray(log[column.name])
            names = tuple(joint.name for joint in joints)
            channels[column.name] = Channel(values, _unit(column, joints), names, column.text)
    return channels


def _unit(column: Column, joints: Sequence[Joint]) -> str:
    """Return the unit of a quantity of these joints, such as `rad | m`."""
    types = {joint.measure for joint in joints}
    coordinate, effort = (
        " | ".join(units[kind] for kind in JointType if kind in types) for units in (_COORDINATE, _EFFORT)
    )
    return column.unit.format(q=coordinate, tau=effort)


_TRACK_TEXTS = {
    "line": "active source line, 0 for none",
    "move": "ordinal of the active move, -1 for none",
    "gripper": "0 open, 1 closed",
    "payload": "mass of tool and grasped part",
}


def track_channel(name: str, values: Array) -> Channel:
    """Return the channel of a piecewise constant quantity with values of shape (rows,)."""
    unit = "kg" if name == "payload" else ""
    return Channel(values, unit, (), _TRACK_TEXTS.get(name, "signal of the cell"))


def pose_channels(kind: str, matrices: Array) -> dict[str, Channel]:
    """Return position and orientation of the TCP.

    Args:
        kind: `attained` or `command`.
        matrices: poses X_BT, shape (rows, 4, 4).
    """
    orientation = quaternions_from_matrices(matrices[:, :3, :3])
    return {
        f"{kind}_position": Channel(
            np.ascontiguousarray(matrices[:, :3, 3]),
            "m",
            ("x", "y", "z"),
            f"{kind} TCP position in the base frame",
        ),
        f"{kind}_orientation": Channel(
            orientation,
            "",
            ("w", "x", "y", "z"),
            f"{kind} TCP orientation in the base frame, unit quaternion",
        ),
    }
