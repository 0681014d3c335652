"""Power that the drives of an arm draw, row by row, from recorded columns."""

from collections.abc import Mapping

import numpy as np

from ropsim.dynamics import drive_power, structure_of
from ropsim.model import RobotModel
from ropsim.simulation.servo.log import LogLayout
from ropsim.spatial import Array

POWER = "power"
"""Name of the channel."""


def drive_powers(robot: RobotModel, log: Mapping[str, Array]) -> dict[str, Array]:
    """Return the power of each drive [W], negative while it returns some, shape (rows, n), by its name.

    Nothing for an arm without drives, and for a log of an arm that follows its reference exactly.

    Args:
        robot: the arm.
        log: arrays by quantity, a column for each joint that has it.
    """
    fields = LogLayout.of(structure_of(robot).drives).fields
    if not robot.drives or any(field.name not in log for field in fields):
        return {}
    powers = np.empty(log["q"].shape)
    for axis, drive in enumerate(robot.drives):
        own = {
            field.name: log[field.name][:, field.axes.index(axis)] for field in fields if axis in field.axes
        }
        powers[:, axis] = drive_power(drive, own)
    return {POWER: powers}
