"""Orientations as angles: roll, pitch, yaw of a frame, and pitch, roll, yaw of an approach direction."""

from math import atan2, cos, hypot, pi, sin, sqrt

import numpy as np

from ropsim.spatial.pose import Pose, frozen
from ropsim.spatial.quaternion import Quaternion, conjugate, from_zyx, multiply

TOOL_FROM_APPROACH: Quaternion = (sqrt(0.5), 0.0, sqrt(0.5), 0.0)
"""Ry(90°): turns the approach axis +x of pitch, roll and yaw to the tool's z axis."""

ALONG_X = Pose(orientation=frozen([sqrt(0.5), 0.0, sqrt(0.5), 0.0]))
"""Ry(90°): turns z to x, and x against z."""
ALONG_Y = Pose(orientation=frozen([sqrt(0.5), -sqrt(0.5), 0.0, 0.0]))
"""Rx(-90°): turns z to y, and y against z."""

_ROUNDING = 2e-15  # rad; angles nearer than that to quarter turns are quarter turns
_UPRIGHT = 1e-9  # rad; an approach direction that is nearer than that to the vertical is vertical


def roll_pitch_yaw(X: Pose) -> tuple[float, float, float]:
    """Return the angles (roll, pitch, yaw) [rad] of the orientation of a pose.

    Pitch and roll are taken from the rotation remaining without yaw, so that the three reproduce the rotation
    to its last bits in every position, including upright ones.
    """
    (xx, xy, xz), (yx, yy, yz), (zx, _, _) = X.rotation().tolist()
    yaw = _snapped(atan2(yx, xx)) if hypot(yx, xx) > 1e-15 else 0.0
    s, c = sin(yaw), cos(yaw)
    pitch = atan2(-zx, c * xx + s * yx)
    roll = atan2(s * xz - c * yz, c * yy - s * xy)
    return _snapped(roll), _snapped(pitch), yaw


def approach_orientation(pitch: float, roll: float, yaw: float) -> Quaternion:
    """Return the orientation of a tool from the angles of its approach direction.

    R = Rz(yaw)·Ry(pitch)·Rx(roll)·Ry(90°). The tool's z axis is the x axis of the first three turns:
    level at pitch 0, down at pitch 90°, along +x at yaw 0. Roll turns the tool about its z axis. It is the
    convention of `(x, y, z, pitch, roll)` in the task language, where yaw is the azimuth of the point.

    Args:
        pitch: angle of the approach direction below the level [rad].
        roll: angle about the approach direction [rad].
        yaw: azimuth of the approach direction [rad].
    """
    return multiply(from_zyx(yaw, pitch, roll), TOOL_FROM_APPROACH)


def pitch_roll_yaw(X: Pose) -> tuple[float, float, float]:
    """Return the angles (pitch, roll, yaw) [rad] of `approach_orientation` for the orientation of a pose.

    A tool that points straight down or up has roll 0: roll and yaw turn about the same axis there.
    """
    w, i, j, k = X.as_tuple()[3:]
    q = multiply((w, i, j, k), conjugate(TOOL_FROM_APPROACH))
    approach = Pose(np.zeros(3), np.array(q))
    (xx, _, _), (yx, yy, yz), (zx, _, _) = approach.rotation().tolist()
    if hypot(xx, yx) > _UPRIGHT:
        roll, pitch, yaw = roll_pitch_yaw(approach)
        return pitch, _forward(roll), _forward(yaw)
    if zx < 0.0:  # down: R = Rz(yaw - roll)·Ry(90°)
        return pi / 2.0, 0.0, _forward(_snapped(atan2(yz, yy)))
    return -pi / 2.0, 0.0, _forward(_snapped(atan2(-yz, yy)))


def _forward(angle: float) -> float:
    """Return half a turn back as half a turn: the sign of a zero decides between them."""
    return pi if angle < _UPRIGHT - pi else angle


def _snapped(angle: float) -> float:
    quarter = round(angle / (pi / 2.0)) * (pi / 2.0)
    return (quarter or 0.0) if abs(angle - quarter) < _ROUNDING else angle
