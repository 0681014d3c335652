"""The own format beside those of others; what reads and writes it is loaded when it is first used."""

from typing import TYPE_CHECKING

from ropsim.core import SourceText
from ropsim.model import RobotModel, WrittenRobot

if TYPE_CHECKING:
    from ropsim.nirox import Beside, ReadNirox


def read_nirox(source: SourceText) -> "ReadNirox":
    """Return the robot of a NIROX file: `ropsim.nirox.read_nirox`.

    Args:
        source: content of the file; any text is allowed.
    """
    from ropsim.nirox import read_nirox as read

    return read(source)


def write_nirox(robot: RobotModel, beside: "Beside | None" = None) -> WrittenRobot:
    """Return the NIROX file of a robot: `ropsim.nirox.write_nirox`.

    Args:
        robot: to be written.
        beside: what the file that it comes from said besides; None for nothing.

    Raises:
        MechanismError: the robot cannot be.
    """
    from ropsim.nirox import write_nirox as write

    return write(robot, beside) if beside is not None else write(robot)
