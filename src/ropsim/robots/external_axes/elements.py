"""Common elements of the mechanisms of this folder: colours, drives, homogeneous bodies, frames."""

import numpy as np

from ropsim.model import Drive, EffortAmplifier, Friction, Gear, IdealMotor, OriginKind, ParameterOrigin
from ropsim.spatial import ALONG_X, Array

PLATE, ACCENT = "#cfd4d8", "#e2702b"
BACK = ALONG_X.inverse()
"""From the frame of a joint along x to that of its carrier."""
ESTIMATE = (
    ParameterOrigin(
        "limits, masses, drive",
        OriginKind.ESTIMATED,
        "round numbers for equipment of this kind; set by the caller",
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
