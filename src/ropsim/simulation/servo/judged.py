"""Quantities of a servo simulation that are judged at every control tick, and their limits."""

from dataclasses import replace

import numpy as np

from ropsim.dynamics import SUPPLY, DriveChain, Limit, LimitSort, chain_of, structure_of
from ropsim.model import Drive, Hydraulic, RobotModel
from ropsim.simulation.records.fields import Field
from ropsim.simulation.servo.log import REFERENCE_COLUMNS, LogLayout, floors
from ropsim.spatial import Array

BELOW = "below "
"""Prefix of the names of margins: the distance of a drive's quantity from its lower bound."""


def judged(chains: tuple[DriveChain, ...]) -> tuple[Field, ...]:
    """Return the fields of the tally of an arm with these drives; its table is as wide as a row of the log.

    Quantities of arm and drives stand where they are in a row. The way beyond the range of a joint stands in
    place of its coordinate, its following error in place of the reference, and in place of a quantity that
    cannot be below a value by how much it is.
    """
    log, least = LogLayout.of(chains), floors(chains)
    q, q_ref = log.field("q"), log.field("q_ref")
    references = {column.name for column in REFERENCE_COLUMNS}
    others = tuple(field for field in log.fields if field.name != "q" and field.name not in references)
    others = tuple(replace(one, name=BELOW + one.name) if one.name in least else one for one in others)
    return (Field("overrun", q.axes, q.first), *others, Field("q_error", q_ref.axes, q_ref.first))


def drive_limits(robot: RobotModel) -> dict[Limit, list[int]]:
    """Return the limits that drives have, each with the joints whose drives have it."""
    found: dict[Limit, list[int]] = {}
    for k, chain in enumerate(chain_of(drive) for drive in robot.drives):
        for limit in chain.amplifier.limits:
            found.setdefault(limit, []).append(k)
    return found


def limit_values(robot: RobotModel) -> Array:
    """Return `full_values` and behind them `least_values`, shape (2·w,)."""
    return np.concatenate((full_values(robot), least_values(robot)))


def least_values(robot: RobotModel) -> Array:
    """Return what quantities of drives cannot be below, shape (w,); -inf for others.

    A supply with an accumulator is to stay above what it is precharged to, and above the return. They stand
    where the quantities are in a row of the log.
    """
    chains = structure_of(robot).drives
    log = LogLayout.of(chains)
    values = np.full(log.width, -np.inf)
    for name, least in floors(chains).items():
        field = log.field(name)
        values[field.place] = least
        if name == SUPPLY.name:
            values[field.place] = [supply_floor(robot.drives[axis]) for axis in field.axes]
    return values


def supply_floor(drive: Drive) -> float:
    """Return the pressure that the supply of a drive is to stay above [Pa]."""
    motor, supply = drive.motor, drive.supply
    if supply is None or not isinstance(motor, Hydraulic):
        return -np.inf
    return max(supply.precharge, motor.return_pressure)


def full_values(robot: RobotModel) -> Array:
    """Return the magnitudes from which on values count as at their limits, shape (w,); infinite for none.

    They stand where the quantities are in a row of the log.
    """
    log = LogLayout.of(structure_of(robot).drives)
    values = np.full(log.width, np.inf)
    for limit, axes in drive_limits(robot).items():
        if limit.sort is LimitSort.LASTING:
            field = log.field(limit.column)
            for axis in axes:
                bound = float(getattr(robot.drives[axis].amplifier, limit.number))
                values[field.first + field.axes.index(axis)] = bound * limit.near
    return values
