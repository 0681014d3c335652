"""A link that a cylinder lifts, and the hydraulics of a timber crane of about that size."""

from math import pi

import numpy as np

from ropsim.model import (
    Drive,
    Friction,
    HydraulicCylinder,
    Joint,
    JointType,
    Link,
    RobotModel,
    ValveAmplifier,
    linkage,
)
from ropsim.spatial import Pose

CYLINDER = HydraulicCylinder(
    area_a=pi / 4 * 0.1**2,
    area_b=pi / 4 * (0.1**2 - 0.056**2),
    stroke=0.535,
    dead_volume_a=4e-4,
    dead_volume_b=3e-4,
    leakage=3e-12,
    moving_mass=14.0,
    supply_pressure=160e5,
    return_pressure=1e5,
    bulk_modulus=1.1e9,
    rated_flow=24e-3 / 60.0,
    rated_pressure_drop=70e5,
    rated_input=0.7,
    natural_frequency=300.0,
    damping_ratio=0.8,
)
CARRIER_PIN, LINK_PIN, RETRACTED = (0.26, -1.04, 0.0), (0.30419, -0.10001, 0.0), 0.82
LOWER, UPPER = -0.4, 1.5
DRIVE = Drive(
    ValveAmplifier(0.7),
    CYLINDER,
    linkage(CARRIER_PIN, LINK_PIN, RETRACTED, 0.5),
    Friction(viscous=2e3, coulomb_positive=800.0, coulomb_negative=-800.0, smoothing_speed=0.02),
)
MASS, CENTRE, INERTIA = 150.0, (1.2, 0.06), 67.0
"""Of the link [kg], [m], about its centre of mass [kg·m²]."""
UPRIGHT = Pose(orientation=np.array([1.0, 1.0, 0.0, 0.0]))
"""The link turns in the x-z plane of the base; positive angles lift it."""


def lifted(drive: Drive = DRIVE) -> RobotModel:
    """Return a base with one link that a drive lifts."""
    joint = Joint("lift", JointType.REVOLUTE, UPRIGHT, 0.0, LOWER, UPPER, 0.5, 1.0, 10.0)
    link = Link(MASS, np.array([*CENTRE, 0.0]), np.diag([1.0, INERTIA, INERTIA]))
    return RobotModel("lifted", "lifted", (joint,), (link,), (drive,), np.array([0.3]))
