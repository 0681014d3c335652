"""Access to the own format in addition to other formats; its reader and writer are loaded on first use."""

from typing import TYPE_CHECKING

from ropsim.core import Diagnostic, SourceText, plural
from ropsim.exchange.losses.gathered import listed
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION
from ropsim.model import RobotModel, WrittenRobot

if TYPE_CHECKING:
    from ropsim.nirox import FurtherData, ReadNirox


def read_nirox(source: SourceText) -> "ReadNirox":
    """Return the robot of a NIROX file: `ropsim.nirox.read_nirox`.

    Args:
        source: content of the file; any text is allowed.
    """
    from ropsim.nirox import read_nirox as read

    return read(source)


def write_nirox(robot: RobotModel, further: "FurtherData | None" = None) -> WrittenRobot:
    """Return the NIROX file of a robot: `ropsim.nirox.write_nirox`.

    Args:
        robot: to be written.
        further: other data of the file that it comes from; None for none.

    Raises:
        MechanismError: the robot cannot be.
    """
    from ropsim.nirox import write_nirox as write

    return write(robot, further) if further is not None else write(robot)


def kept_lost(further: "FurtherData") -> tuple[Diagnostic, ...]:
    """Return the losses of a robot that leaves the format that keeps the other data of its file.

    Args:
        further: other data of a NIROX file, or one of AP242.
    """
    if not further.numbers:
        return ()
    names = listed(further.instances[number].keyword for number in further.numbers)
    count = plural(len(further.numbers), "thing")
    words = f"what its file says beside the robot does not go over, {count}: {names}"
    return (LOST_DESCRIPTION.at(None, words, hint="NIROX (`.stp`) keeps them"),)
