"""Poses in MJCF: a position, and an orientation in one of five ways."""

from math import cos, sin, sqrt

import numpy as np

from ropsim.exchange.files.values import direction_of, numbers_of
from ropsim.exchange.files.xml_tree import Element
from ropsim.exchange.losses.diagnostics import BAD_NUMBER
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.mjcf.settings import Settings
from ropsim.spatial import Array, Pose, quaternion, quaternion_from_matrix

_ZERO = (0.0, 0.0, 0.0)
_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


def pose_of(element: Element, settings: Settings, notes: Notes) -> Pose:
    """Return the pose of an element in the frame around it; the identity where it says none."""
    position = np.array(numbers_of(element, "pos", notes, _ZERO))
    if "quat" in element.attributes:
        w, x, y, z = numbers_of(element, "quat", notes, (1.0, 0.0, 0.0, 0.0))
        if sqrt(w * w + x * x + y * y + z * z) < 1e-9:
            words = f"the quaternion of `{element.name}` is zero"
            notes.add(BAD_NUMBER, element.span, words, "write 1 0 0 0 for no turn")
            return Pose(position)
        return Pose(position, np.array([w, x, y, z]))
    return Pose(position, np.array(_turn(element, settings, notes)))


def _turn(element: Element, settings: Settings, notes: Notes) -> quaternion.Quaternion:
    if "axisangle" in element.attributes:
        x, y, z, angle = numbers_of(element, "axisangle", notes, (0.0, 0.0, 1.0, 0.0))
        return about((x, y, z), angle * settings.angle_unit)
    if "euler" in element.attributes:
        turn = quaternion.IDENTITY
        angles = numbers_of(element, "euler", notes, _ZERO)
        for letter, angle in zip(settings.euler_order, angles, strict=False):
            one = about(_AXES.get(letter.lower(), _AXES["x"]), angle * settings.angle_unit)
            turn = quaternion.multiply(turn, one) if letter.islower() else quaternion.multiply(one, turn)
        return turn
    if "zaxis" in element.attributes:
        return from_z(direction_of(element, "zaxis", notes, _AXES["z"]))
    if "xyaxes" in element.attributes:
        values = np.array(numbers_of(element, "xyaxes", notes, (1.0, 0.0, 0.0, 0.0, 1.0, 0.0)))
        ahead, aside = values[:3], values[3:]
        aside = aside - ahead * (ahead @ aside) / max(float(ahead @ ahead), 1e-300)
        if min(np.linalg.norm(ahead), np.linalg.norm(aside)) > 1e-9:
            ahead, aside = ahead / np.linalg.norm(ahead), aside / np.linalg.norm(aside)
            return _quaternion(np.column_stack((ahead, aside, np.cross(ahead, aside))))
        words = f"the axes of `{element.name}` are zero or along one line"
        notes.add(BAD_NUMBER, element.span, words, "write two vectors across each other")
    return quaternion.IDENTITY


def about(axis: tuple[float, float, float], angle: float) -> quaternion.Quaternion:
    """Return the turn about an axis by an angle [rad]; none where the axis is zero."""
    x, y, z = axis
    length = sqrt(x * x + y * y + z * z)
    if length < 1e-9:
        return quaternion.IDENTITY
    s = sin(angle / 2.0) / length
    return quaternion.normalize((cos(angle / 2.0), s * x, s * y, s * z))


def from_z(z: tuple[float, float, float]) -> quaternion.Quaternion:
    """Return the shortest turn that brings the z axis to a unit vector."""
    if z[2] < -1.0 + 1e-12:
        return (0.0, 1.0, 0.0, 0.0)
    return quaternion.normalize((1.0 + z[2], -z[1], z[0], 0.0))


def _quaternion(rotation: Array) -> quaternion.Quaternion:
    w, x, y, z = quaternion_from_matrix(rotation).tolist()
    return (w, x, y, z)
