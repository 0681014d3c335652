"""An arm as if its elastic gears were rigid: what its motors have to do for a motion without swings.

Behind a spring a motor turns separately, so that joints do not feel its inertia and friction; along a smooth
motion it has to move both all the same.
"""

from dataclasses import replace
from functools import lru_cache
from typing import TypeVar

from ropsim.model import Drive, ElasticGear, Gear, Mechanism

Arm = TypeVar("Arm", bound=Mechanism)


@lru_cache(maxsize=64)
def with_rigid_gears(robot: Arm) -> Arm:
    """Return the arm with rigid gears of the same ratios; the arm itself where all are rigid."""
    if not any(isinstance(drive.transmission, ElasticGear) for drive in robot.drives):
        return robot
    return replace(robot, drives=tuple(map(_rigid, robot.drives)))


def _rigid(drive: Drive) -> Drive:
    gear = drive.transmission
    return replace(drive, transmission=Gear(gear.ratio)) if isinstance(gear, ElasticGear) else drive
