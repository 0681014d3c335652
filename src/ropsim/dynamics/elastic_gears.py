"""The elastic gears and links of an arm, and the arm as if they were rigid: what motors do without swings.

Behind a spring a motor turns separately, so that joints do not feel its inertia and friction; along a smooth
motion it has to move both all the same.
"""

from dataclasses import replace
from functools import lru_cache
from typing import TypeVar

import numpy as np

from ropsim.model import Drive, Elastic, Gear, HydraulicCylinder, Mechanism
from ropsim.spatial import Array

Arm = TypeVar("Arm", bound=Mechanism)


def elastic_axes(robot: Mechanism) -> Array:
    """Return which axes have elastic gears, or links that yield at their drives, shape (n,)."""
    return np.isfinite(gear_stiffnesses(robot))


def gear_stiffnesses(robot: Mechanism) -> Array:
    """Return the stiffness of gear and link of each axis [N·m/rad | N/m], shape (n,); inf for rigid ones."""
    return np.array([_stiffness(drive) for drive in robot.drives])


def _stiffness(drive: Drive) -> float:
    """Return the stiffness of a gear with that of a link behind it [N·m/rad | N/m]."""
    gear = drive.transmission.stiffness if isinstance(drive.transmission, Elastic) else np.inf
    if drive.link is None:
        return gear
    return drive.link.stiffness if gear == np.inf else 1.0 / (1.0 / gear + 1.0 / drive.link.stiffness)


@lru_cache(maxsize=64)
def with_rigid_gears(robot: Arm) -> Arm:
    """Return the arm with rigid gears of the same ratios and rigid links; the arm itself where all are.

    A hub before an elastic link turns with the rotor behind a gear then; one that a cylinder moves is left
    out.

    Its torques are those that the motors give, seen at the joints. While an arm swings, the torques in its
    elastic gears are others.
    """
    if not any(isinstance(drive.transmission, Elastic) or drive.link for drive in robot.drives):
        return robot
    return replace(robot, drives=tuple(map(_rigid, robot.drives)))


def _rigid(drive: Drive) -> Drive:
    gear = drive.transmission
    if drive.link and not isinstance(drive.motor, HydraulicCylinder):
        own = drive.link.hub_inertia / drive.ratio_at(0.0) ** 2
        drive = replace(drive, motor=replace(drive.motor, rotor_inertia=drive.motor.rotor_inertia + own))
    if isinstance(gear, Elastic):
        drive = replace(drive, transmission=Gear(gear.ratio))
    return replace(drive, link=None)
