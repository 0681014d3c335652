"""Frames whose z axis is an axis of a file: joints of the model move about and along their own z axis."""

from math import cos, sin

import numpy as np

from ropsim.exchange.description import Connection, Motion
from ropsim.spatial import Array, Pose, quaternion_from_matrix

_NO_WAY = np.zeros(3)


def aligned(axis: tuple[float, float, float]) -> Pose:
    """Return a frame with its z along a unit vector, shape (3,), in the frame of that; the identity for z.

    Axes along coordinate axes give frames along coordinate axes, so that right angles stay right.
    """
    z = np.array(axis)
    if z[2] == 1.0:
        return Pose()
    x = np.zeros(3)
    x[(int(np.argmax(np.abs(z))) + 1) % 3] = 1.0
    x -= (x @ z) * z
    x /= np.linalg.norm(x)
    return Pose(_NO_WAY, quaternion_from_matrix(np.column_stack((x, np.cross(z, x), z))))


def displaced(one: Connection, value: float) -> Pose:
    """Return the frame of the child of a connection in that of its parent, at a coordinate [rad | m]."""
    way = value - one.zero
    axis: Array = np.array(one.axis)
    if one.motion is Motion.SLIDE:
        return one.X_PC @ Pose(way * axis)
    if one.motion is Motion.TURN:
        turn = np.array([cos(way / 2.0), *(sin(way / 2.0) * axis)])
        return one.X_PC @ Pose(_NO_WAY, turn)
    return one.X_PC
