"""Masses that a file leaves out: each link taken for a cylinder from joint to joint.

The cylinders get thinner towards the tip, as the links of arms do. It is a rule to get torques of the right
size with, no substitute for a data sheet; the origins of a robot say which numbers it made.
"""

from collections.abc import Sequence

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.model import Joint
from ropsim.spatial import Array, Pose

THICKEST = 0.05
"""Radius of the first cylinder over the sum of all lengths."""
TAPER = 0.6
"""Share of that radius that is lost up to the last link."""

RULE = (
    f"homogeneous cylinders from joint to joint, radius {100 * THICKEST:.0f} % of the sum of lengths at the "
    f"first link and {100 * THICKEST * (1 - TAPER):.0f} % at the last, at least as long as thick"
)


@frozen_dataclass
class Cylindrical:
    """A link taken for a cylinder.

    Attributes:
        middle: of the cylinder in the frame of the joint [m], three numbers.
        direction: of its axis, a unit vector.
        radius: [m].
        length: [m].
    """

    middle: tuple[float, float, float]
    direction: tuple[float, float, float]
    radius: float
    length: float

    @property
    def volume(self) -> float:
        """Return the volume over π [m³]."""
        return self.radius**2 * self.length

    def inertia(self, mass: float) -> Array:
        """Return the tensor about the middle in the axes of the joint [kg·m²], shape (3, 3)."""
        across = mass * (3.0 * self.radius**2 + self.length**2) / 12.0
        along = mass * self.radius**2 / 2.0
        return np.asarray(across * np.eye(3) + (along - across) * np.outer(self.direction, self.direction))


def cylinders(joints: Sequence[Joint], X_nM: Pose) -> tuple[Cylindrical, ...]:
    """Return the cylinders of the links of a serial arm.

    Args:
        joints: from the base on.
        X_nM: mechanical interface in the frame of the last joint.
    """
    ends = [*(joint.placement.position for joint in joints[1:]), X_nM.position]
    whole = float(np.linalg.norm(joints[0].placement.position)) + sum(map(float, map(np.linalg.norm, ends)))
    return tuple(_cylinder(end, whole, number, len(joints)) for number, end in enumerate(ends))


def _cylinder(end: Array, whole: float, number: int, count: int) -> Cylindrical:
    radius = max(THICKEST * whole, 1e-3) * (1.0 - TAPER * number / max(count - 1, 1))
    length = float(np.linalg.norm(end))
    x, y, z = (end / length).tolist() if length > radius else (0.0, 0.0, 1.0)
    a, b, c = (0.5 * end).tolist()
    return Cylindrical((a, b, c), (x, y, z), radius, max(length, 2.0 * radius))
