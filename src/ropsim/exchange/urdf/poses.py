"""Poses in URDF: `origin` with position and angles of roll, pitch and yaw about fixed axes."""

from math import atan2, cos, hypot, pi, sin

import numpy as np

from ropsim.exchange.notes import Notes
from ropsim.exchange.values import numbers_of
from ropsim.exchange.xml_tree import Element
from ropsim.spatial import Pose, quaternion

_ZERO = (0.0, 0.0, 0.0)
_ROUNDING = 2e-15  # rad; angles nearer than that to quarter turns are quarter turns


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


def roll_pitch_yaw(X: Pose) -> tuple[float, float, float]:
    """Return the angles (roll, pitch, yaw) [rad] of the orientation of a pose.

    Pitch and roll are taken from what is left of the rotation when yaw has been taken back, so that the three
    give the rotation to its last bits in every position, upright ones too.
    """
    (xx, xy, xz), (yx, yy, yz), (zx, _, _) = X.rotation().tolist()
    yaw = _snapped(atan2(yx, xx)) if hypot(yx, xx) > 1e-15 else 0.0
    s, c = sin(yaw), cos(yaw)
    pitch = atan2(-zx, c * xx + s * yx)
    roll = atan2(s * xz - c * yz, c * yy - s * xy)
    return _snapped(roll), _snapped(pitch), yaw


def _snapped(angle: float) -> float:
    quarter = round(angle / (pi / 2.0)) * (pi / 2.0)
    return (quarter or 0.0) if abs(angle - quarter) < _ROUNDING else angle
