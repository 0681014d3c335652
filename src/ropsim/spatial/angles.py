"""Orientations as angles about fixed axes: roll about x, pitch about y, yaw about z, in this order."""

from math import atan2, cos, hypot, pi, sin

from ropsim.spatial.pose import Pose

_ROUNDING = 2e-15  # rad; angles nearer than that to quarter turns are quarter turns


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
