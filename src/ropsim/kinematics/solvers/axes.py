"""The axes of an arm at coordinate zero, and axes turned slightly to satisfy a class of arms exactly."""

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.solutions.solver import Snap
from ropsim.spatial import Array, record

ANGLE_SLACK = 1e-3
"""Directions count as parallel or perpendicular within this [rad]: files write 90° as 1.57 or 1.5708."""
LENGTH_SLACK = 1e-5
"""Axes count as meeting within this [m], once their directions are snapped: files are rounded to 0.01 mm."""
NEAR_SINGULAR = 0.15
"""Configurations this near to a singular one [m, rad] may have a singular pose in their neighbourhood."""
COUPLED = "its interface is moved by couplings, or not by each of its axes alone"
"""Reason why an arm belongs to no class of serial arms."""
EXACT = 1e-12
"""A model this near to its class [rad, m] needs no polishing: poses are promised to 1e-9."""


@record
class ZeroFrames:
    """The joint frames of an arm with all motions at zero, in the frame of its first joint, J.

    Attributes:
        R: their rotations, shape (n, 3, 3); column 2 is the axis.
        p: their origins [m], shape (n, 3).
        steps: each rotation in the frame before it, shape (n, 3, 3); row 0 has no meaning.
    """

    R: Array
    p: Array
    steps: Array

    @classmethod
    def of(cls, chain: ChainArrays) -> "ZeroFrames":
        """Return the frames of a chain."""
        R, p = np.eye(3), np.zeros(3)
        rotations, origins = [R], [p]
        for i in range(1, len(chain.p)):
            p = p + R @ chain.p[i]
            R = R @ chain.R[i]
            rotations.append(R)
            origins.append(p)
        return cls(np.array(rotations), np.array(origins), chain.R)

    @property
    def axes(self) -> Array:
        """Return the directions of the axes, shape (n, 3)."""
        axes: Array = self.R[:, :, 2]
        return axes

    def snapped(self, axes: Array) -> tuple["ZeroFrames", float]:
        """Return the frames with their axes turned to `axes` (n, 3), and the largest angle [rad]."""
        angle = max(map(angle_between, self.axes, axes))
        if angle <= EXACT:
            return self, 0.0
        turned = zip(self.axes, axes, self.R, strict=True)
        R = np.array([turn_between(old, new) @ frame for old, new, frame in turned])
        steps = np.concatenate((self.steps[:1], R[:-1].transpose(0, 2, 1) @ R[1:]))
        return ZeroFrames(R, self.p, steps), angle


def snap(angle: float, length: float) -> Snap:
    """Return the deviation of a model from its class, without rounding errors."""
    return Snap(angle, length) if max(angle, length) > EXACT else Snap()


def angle_between(one: Array, other: Array) -> float:
    """Return the angle between two directions [rad], exact where it is small."""
    return float(np.arctan2(np.linalg.norm(np.cross(one, other)), one @ other))


def angle_of_turn(X: Array, other: Array) -> float:
    """Return the angle between the orientations of two homogeneous matrices [rad]."""
    C = X[:3, :3] @ other[:3, :3].T
    vector = np.array([C[2, 1] - C[1, 2], C[0, 2] - C[2, 0], C[1, 0] - C[0, 1]])
    return float(np.arctan2(np.linalg.norm(vector), np.trace(C) - 1.0))


def across(direction: Array, axis: Array) -> Array:
    """Return the direction nearest to `direction` that is perpendicular to `axis`; both of length 1."""
    flat = direction - (direction @ axis) * axis
    return np.asarray(flat / np.linalg.norm(flat))


def along(direction: Array, axis: Array) -> Array:
    """Return `axis` or its opposite, the one nearer to `direction`."""
    return axis if float(direction @ axis) >= 0.0 else -axis


def turn_between(one: Array, other: Array) -> Array:
    """Return the shortest rotation that takes direction `one` to `other`, which is not its opposite."""
    x, y, z = np.cross(one, other).tolist()
    W = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + W + W @ W / (1.0 + float(one @ other)))


def distance(point: Array, origins: Array, axes: Array) -> float:
    """Return the largest distance of a point from lines through origins (k, 3) along axes (k, 3)."""
    return float(np.linalg.norm(np.cross(axes, point - origins), axis=1).max())
