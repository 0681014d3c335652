"""A robot as instances, and its losses."""

from ropsim.core import Diagnostic, frozen_without_equality
from ropsim.model import RobotModel
from ropsim.nirox.building import Building, FurtherFrame
from ropsim.nirox.writers.arm import arm_losses, write_arm, write_origins
from ropsim.nirox.writers.bodies import write_bodies, write_looks
from ropsim.nirox.writers.drives import drive_losses, write_drives
from ropsim.nirox.writers.springs import write_springs


@frozen_without_equality
class Built:
    """A robot as instances.

    Attributes:
        building: the instances.
        losses: losses.
    """

    building: Building
    losses: tuple[Diagnostic, ...]


def built(robot: RobotModel, frames: tuple[FurtherFrame, ...] = ()) -> Built:
    """Return the instances of a robot.

    Args:
        robot: to be written.
        frames: on its links, in addition to the mechanical interface.
    """
    building = Building()
    writing = write_arm(building, robot, frames)
    write_bodies(building, robot)
    write_drives(building, robot)
    write_springs(building, robot)
    write_looks(building, robot)
    write_origins(building, robot)
    losses = (*writing.losses(), *drive_losses(robot), *arm_losses(robot))
    return Built(building, losses)
