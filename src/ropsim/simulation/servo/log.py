"""Data that a servo simulation records at a tick: the fields of a row of its log."""

from collections.abc import Mapping
from math import inf

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.dynamics import SUPPLY, Column, DriveChain, structure_of
from ropsim.model import RobotModel
from ropsim.simulation.records.fields import Field, fields
from ropsim.spatial import Array

ARM_COLUMNS = (
    Column("q", "{q}", "attained joint coordinates"),
    Column("qd", "{q}/s", "attained joint speeds"),
    Column("tau", "{tau}", "torque of the drive at the joint, before friction"),
)
REFERENCE_COLUMNS = (
    Column("q_ref", "{q}", "joint references"),
    Column("qd_ref", "{q}/s", "reference joint speeds"),
)
"""Columns of every arm."""


@frozen_dataclass
class LogLayout:
    """The fields of a row: of the arm, of its drives and their amplifiers, and the reference.

    Attributes:
        fields: where each quantity stands.
    """

    fields: tuple[Field, ...]

    @classmethod
    def of(cls, chains: tuple[DriveChain, ...]) -> "LogLayout":
        """Return the fields of an arm with these drives."""
        arm, reference = ([column.name for column in columns] for columns in (ARM_COLUMNS, REFERENCE_COLUMNS))
        drives = tuple(tuple(column.name for column in recorded(chain)) for chain in chains)
        own = list(dict.fromkeys(name for names in drives for name in names))
        order = [*arm, *own, *reference]
        names = tuple(tuple(one for one in order if one not in own or one in names) for names in drives)
        return cls(fields(names, 0) if chains else ())

    @property
    def width(self) -> int:
        """Return the numbers in a row."""
        return sum(len(field.axes) for field in self.fields)

    def field(self, name: str) -> Field:
        """Return the field of a quantity that every row has."""
        return next(field for field in self.fields if field.name == name)


def recorded(chain: DriveChain) -> tuple[Column, ...]:
    """Return the recorded columns of a drive: its states, the output of its amplifier, and its supply."""
    own = (*chain.states, chain.amplifier.output)
    return (*own, SUPPLY) if chain.is_supplied else own


def floors(chains: tuple[DriveChain, ...]) -> dict[str, float]:
    """Return the quantities of drives that cannot be below a value, and that value, by name."""
    columns = dict.fromkeys(column for chain in chains for column in recorded(chain))
    return {column.name: column.least for column in columns if column.least > -inf}


POWER = Column("power", "W", "power that the drive draws; negative where it gives back")
"""Column that is made of the others."""


def drive_powers(robot: RobotModel, log: Mapping[str, Array]) -> dict[str, Array]:
    """Return the power of each drive [W], negative while it returns some, shape (rows, n), by its name.

    Nothing for an arm without drives, and for a log of an arm that follows its reference exactly.

    Args:
        robot: the arm.
        log: arrays by quantity, a column for each joint that has it.
    """
    chains = structure_of(robot).drives
    fields = LogLayout.of(chains).fields
    if not chains or any(field.name not in log for field in fields):
        return {}
    powers = np.empty(log["q"].shape)
    for axis, (chain, drive) in enumerate(zip(chains, robot.drives, strict=True)):
        own = {
            field.name: log[field.name][:, field.axes.index(axis)] for field in fields if axis in field.axes
        }
        powers[:, axis] = chain.power(drive, own)
    return {POWER.name: powers}
