"""Common elements of the mechanisms of this folder: colours, drives, homogeneous bodies, frames."""

import numpy as np

from ropsim.model import Drive, EffortAmplifier, Friction, Gear, IdealMotor, ParameterOrigin
from ropsim.spatial import Array, Pose

FRAME, PLATE, STEEL, ACCENT = "#3d464f", "#cfd4d8", "#a3abb3", "#e2702b"
ALONG_X = Pose(orientation=np.array([1.0, 0.0, 1.0, 0.0]))
"""Ry(90°): z of a joint points along x of its carrier, and its x axis down."""
BACK = ALONG_X.inverse()
ESTIMATE = (
    ParameterOrigin(
        "limits, masses, drive", "estimated", "round numbers for equipment of this kind; set by the caller"
    ),
)
_PINION = 0.04  # [m], radius of a pinion that runs on a rack
_REDUCTION = 8.0  # of the gear before it


def drive(ratio: float, rotor: float, most: float, viscous: float, dry: float) -> Drive:
    """Return an ideal motor behind a gear.

    Args:
        ratio: of motor to axis [- | rad/m].
        rotor: its inertia [kg·m²].
        most: torque of the motor at most [N·m].
        viscous: friction at the motor [N·m·s/rad].
        dry: friction at the motor [N·m].
    """
    return Drive(EffortAmplifier(most), IdealMotor(rotor), Gear(ratio), Friction(viscous, dry, -dry, 0.005))


def rack_drive(most: float) -> Drive:
    """Return the drive of an axis that goes along a rack, for forces up to `most` [N]."""
    return drive(_REDUCTION / _PINION, 3e-3, 1.2 * most * _PINION / _REDUCTION, 1e-3, 0.1)


def box_moments(mass: float, size: tuple[float, float, float]) -> Array:
    """Return the moments of a homogeneous box about its centre [kg·m²], shape (3, 3)."""
    squares = np.array(size) ** 2
    return np.diag(mass / 12.0 * (squares.sum() - squares))


def at(x: float, y: float, z: float) -> Pose:
    """Return a place without a turn [m]."""
    return Pose(np.array([x, y, z]))
