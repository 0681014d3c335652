"""Poses in URDF: `origin` with position and angles of roll, pitch and yaw about fixed axes."""

import numpy as np

from ropsim.exchange.files.values import numbers_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.notes import Notes
from ropsim.spatial import Pose, quaternion

_ZERO = (0.0, 0.0, 0.0)


def origin_of(element: Element, notes: Notes) -> Pose:
    """Return the pose that the `origin` of an element says: R = Rz(yaw)·Ry(pitch)·Rx(roll)."""
    origin = element.first("origin")
    if origin is None:
        return Pose()
    position = np.array(numbers_of(origin, "xyz", notes, _ZERO))
    if "quat_xyzw" in origin.attributes:
        x, y, z, w = numbers_of(origin, "quat_xyzw", notes, (0.0, 0.0, 0.0, 1.0))
        if x or y or z or w:
            return Pose(position, np.array([w, x, y, z]))
    roll, pitch, yaw = numbers_of(origin, "rpy", notes, _ZERO)
    return Pose(position, np.array(quaternion.from_zyx(yaw, pitch, roll)))
