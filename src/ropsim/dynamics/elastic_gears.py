"""The elastic gears of an arm, and the arm as if they were rigid: what motors do for a motion without swings.

Behind a spring a motor turns separately, so that joints do not feel its inertia and friction; along a smooth
motion it has to move both all the same.
"""

from dataclasses import replace
from functools import lru_cache
from typing import TypeVar

import numpy as np

from ropsim.model import Drive, Elastic, Gear, Mechanism
from ropsim.spatial import Array

Arm = TypeVar("Arm", bound=Mechanism)


def elastic_axes(robot: Mechanism) -> Array:
    """Return which axes have elastic gears, shape (n,)."""
    return np.isfinite(gear_stiffnesses(robot))


def gear_stiffnesses(robot: Mechanism) -> Array:
    """Return the stiffness of the gear of each axis [N·m/rad | N/m], shape (n,); inf for rigid gears."""
    gears = [drive.transmission for drive in robot.drives]
    return np.array([one.stiffness if isinstance(one, Elastic) else np.inf for one in gears])


@lru_cache(maxsize=64)
def with_rigid_gears(robot: Arm) -> Arm:
    """Return the arm with rigid gears of the same ratios; the arm itself where all are rigid.

    Its torques are those that the motors give, seen at the joints. While an arm swings, the torques in its
    elastic gears are others.
    """
    if not any(isinstance(drive.transmission, Elastic) for drive in robot.drives):
        return robot
    return replace(robot, drives=tuple(map(_rigid, robot.drives)))


def _rigid(drive: Drive) -> Drive:
    gear = drive.transmission
    return replace(drive, transmission=Gear(gear.ratio)) if isinstance(gear, Elastic) else drive
