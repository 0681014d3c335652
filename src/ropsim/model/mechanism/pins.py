"""The pins of a cylinder, between the frames in which files have them and the frames of the model."""

import numpy as np

from ropsim.model.drives.linkage import Point
from ropsim.model.mechanism.links import Joint
from ropsim.spatial import Array, Pose

DIGITS = 12
"""Pins are kept to a picometre, and written finer, so that conversion to any frame and back is exact."""
WRITTEN = 15
"""Decimals of a pin in a file [m]."""


def carrier_frame(joint: Joint, X_CF: Pose) -> Pose:
    """Return a frame F of the body that carries a turning joint, in that of its link at coordinate 0.

    Args:
        joint: placed on that body C.
        X_CF: the frame in that of the body.
    """
    half = 0.5 * joint.offset
    turned = joint.placement @ Pose(orientation=np.array([np.cos(half), 0.0, 0.0, np.sin(half)]))
    return turned.inverse() @ X_CF


def pin_at(X: Pose, point: Point, digits: int = DIGITS) -> Point:
    """Return a pin of a frame in the frame in which that is at X, rounded to decimals of a metre."""
    x, y, z = _rounded(X.rotation() @ np.array(point) + X.position, digits)
    return x, y, z


def _rounded(point: Array, digits: int) -> list[float]:
    return [round(float(one), digits) + 0.0 for one in point]
