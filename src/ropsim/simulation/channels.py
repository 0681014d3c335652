"""The recorded channels: units, names and meaning."""

from collections.abc import Mapping

import numpy as np

from ropsim.flow import Channel
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, quaternions_from_matrices

_UNITS = {
    "q": "{0}",
    "qd": "{0}/s",
    "tau": "{1}",
    "current": "A",
    "voltage": "V",
    "q_ref": "{0}",
    "qd_ref": "{0}/s",
    "q_error": "{0}",
}
_TEXTS = {
    "q": "attained joint coordinates",
    "qd": "attained joint speeds",
    "tau": "torque of the drive at the joint, before friction",
    "current": "motor current",
    "voltage": "motor voltage",
    "q_ref": "joint references",
    "qd_ref": "reference joint speeds",
    "q_error": "reference minus attained joint coordinates",
}


def joint_channels(robot: RobotModel, log: Mapping[str, Array]) -> dict[str, Channel]:
    """Return the channels of the joints that a log holds.

    Args:
        robot: names and types of the joints.
        log: arrays of shape (rows, n) by channel name; other names are left out.
    """
    types = {joint.type for joint in robot.joints}
    length = {JointType.REVOLUTE: "rad", JointType.PRISMATIC: "m"}
    effort = {JointType.REVOLUTE: "N·m", JointType.PRISMATIC: "N"}
    names = [" | ".join(units[kind] for kind in JointType if kind in types) for units in (length, effort)]
    columns = tuple(joint.name for joint in robot.joints)
    return {
        name: Channel(np.asarray(log[name]), unit.format(*names), columns, _TEXTS[name])
        for name, unit in _UNITS.items()
        if name in log
    }


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
