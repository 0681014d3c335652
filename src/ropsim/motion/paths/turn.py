"""How the tool turns on a straight line: about one fixed axis, or as Paul's drive transform."""

import math

import numpy as np

from ropsim.model import OrientationMode
from ropsim.motion.paths.turn_kernel import turn_between
from ropsim.spatial import Array, Pose, frozen, record

_APPROACH = frozen([0.0, 0.0, 1.0])


@record
class Turn:
    """R(r) = Rot(axis, r·angle)·Rot(z, r·roll) in the tool frame of the start, for r from 0 to 1.

    Attributes:
        axis: unit axis in the tool frame of the start, shape (3,); normal to z where `roll` is not 0.
        angle: [rad], in [0, π].
        roll: about the approach vector, which is z of the tool [rad], in (-π, π].
    """

    axis: Array
    angle: float
    roll: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "axis", frozen(self.axis))

    @property
    def size(self) -> float:
        """Return the angle that the angular speed adds up to [rad]; the two axes stay normal."""
        return math.hypot(self.angle, self.roll)

    def rotations(self, r: Array) -> Array:
        """Return R(r) for values of r of shape (k,), shape (k, 3, 3)."""
        turned = _rotations(self.axis, r * self.angle)
        return turned @ _rotations(_APPROACH, r * self.roll) if self.roll else turned


def plan_turn(X_start: Pose, X_end: Pose, mode: OrientationMode) -> Turn:
    """Return the turn of the tool from `X_start` to `X_end`.

    With a fixed axis the tool turns by the least angle about one axis (spherical linear interpolation).
    With the drive transform the approach vector swings to its goal about the axis normal to both, while the
    tool rolls about it: the approach vector stays in one plane.

    Args:
        X_start: X_BT at the start.
        X_end: X_BT at the end.
        mode: which way.

    References:
        Paul 1979, Manipulator Cartesian Path Control, IEEE Transactions on Systems, Man, and Cybernetics 9,
        for the drive transform; Shoemake 1985, Animating Rotation with Quaternion Curves, for the fixed
        axis.
    """
    found, drives = np.empty(5), int(mode is OrientationMode.DRIVE_TRANSFORM)
    turn_between(X_start.orientation, X_end.orientation, drives, found)
    angle, roll = found[3:].tolist()
    return Turn(found[:3], angle, roll)


def _rotations(axis: Array, angles: Array) -> Array:
    """Return Rot(axis, angle) for angles of shape (k,), shape (k, 3, 3) (Rodrigues' formula)."""
    x, y, z = axis.tolist()
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    sines = np.sin(angles)[:, None, None]
    versines = 2.0 * np.square(np.sin(angles / 2.0))[:, None, None]
    result: Array = np.eye(3) + sines * K + versines * (K @ K)
    return result
