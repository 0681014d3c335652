"""The recorded channels of the joints: units, names and meaning."""

from collections.abc import Mapping

import numpy as np

from ropsim.flow import Channel
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array

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
