"""The fixed rotations and shifts of a mechanism as matrices, with the exact zeros and ones of the drawing.

A quaternion of a right angle yields cosines such as 2e-16. Code generators drop a term only where the factor
is exactly zero, so entries that are 0 or ±1 to rounding are set so here.
"""

from functools import lru_cache

import numpy as np

from ropsim.model.mechanism.joint_tree import JointTree
from ropsim.spatial import Array, Pose, frozen

SNAP = 1e-15
"""Entries this near to -1, 0 or 1 are rounding, not geometry: no drawing specifies angles to 1e-15 rad."""


def snapped(matrix: Array) -> Array:
    """Return a copy in which entries within `SNAP` of -1, 0 or 1 are exactly that; any shape."""
    nearest = np.round(matrix)
    whole = (np.abs(matrix - nearest) <= SNAP) & (np.abs(nearest) <= 1.0)
    return np.where(whole, nearest + 0.0, matrix)


@lru_cache(maxsize=1024)
def pose_matrices(pose: Pose) -> tuple[Array, Array]:
    """Return (R_AB, p_AB) of a pose X_AB, shapes (3, 3) and (3,) [m], entries snapped, read-only."""
    return frozen(snapped(pose.rotation())), frozen(snapped(pose.position))


def placement_matrices(tree: JointTree) -> tuple[Array, Array]:
    """Return the fixed part of every step: its frame at coordinate 0 in the frame of its parent.

    Args:
        tree: m steps.

    Returns:
        R, shape (m, 3, 3), entries within 1e-15 of 0 and ±1 exact; p [m], shape (m, 3).
    """
    pairs = [pose_matrices(placement) for placement in tree.placements]
    rotations = np.array([rotation for rotation, _ in pairs]).reshape(tree.m, 3, 3)
    positions = np.array([position for _, position in pairs]).reshape(tree.m, 3)
    return rotations, positions
