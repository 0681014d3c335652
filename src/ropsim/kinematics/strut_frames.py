"""Frames of struts: what hangs on one pin of a linkage and points to the other."""

import numpy as np

from ropsim.model import Mechanism, Strut, StrutEnd
from ropsim.spatial import Array

_NO_WAY = 1e-12
"""Pins that are nearer to each other point nowhere [m]."""


def strut_frames(mechanism: Mechanism, strut: Strut, frames: Array) -> Array:
    """Return the frames of a strut in the base frame of its mechanism, shape (k, 4, 4).

    Args:
        mechanism: that has the joint of the linkage.
        strut: which pin, and of what.
        frames: of all links, as `frames_batch` returns them, shape (k, links + 1, 4, 4).
    """
    joint = mechanism.joints[strut.joint]
    placed = joint.placement.matrix()
    carrier = placed if joint.parent < 0 else frames[:, joint.parent] @ placed
    before = _point(carrier, strut.linkage.carrier_pin)
    behind = _point(frames[:, strut.joint], strut.linkage.link_pin)
    way = behind - before
    length = np.linalg.norm(way, axis=1, keepdims=True)
    axis = np.broadcast_to(carrier[..., :3, 2], way.shape)
    z = np.where(length > _NO_WAY, way / np.maximum(length, _NO_WAY), np.roll(axis, 1, axis=1))
    x = axis - (axis * z).sum(axis=1, keepdims=True) * z
    x = x / np.linalg.norm(x, axis=1, keepdims=True)
    X = np.zeros((len(frames), 4, 4))
    X[:, :3, 0], X[:, :3, 1], X[:, :3, 2] = x, np.cross(z, x), z
    X[:, :3, 3], X[:, 3, 3] = (before if strut.end is StrutEnd.CARRIER else behind), 1.0
    return X


def _point(X: Array, p: tuple[float, float, float]) -> Array:
    """Return a point of frames (k, 4, 4) or of one frame (4, 4) in the base frame, shape (k, 3) or (3,)."""
    return np.asarray(X[..., :3, :3] @ np.array(p) + X[..., :3, 3])
