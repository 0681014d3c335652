"""Numbers and joint coordinates as people type and read them."""

import math
from collections.abc import Iterable, Mapping
from types import MappingProxyType

from ropsim.core import Category, RopsimError, Severity, define, frozen_dataclass
from ropsim.model import JointType, RobotModel

FARTHEST: Mapping[JointType, float] = MappingProxyType(
    {JointType.REVOLUTE: 36_000.0, JointType.PRISMATIC: 100_000.0}
)
"""Largest coordinate either way: a hundred turns [deg], the bound of positions in a cell file [mm]."""

BEYOND_SENSE = define(
    "U903",
    "coordinate-beyond-sense",
    Severity.ERROR,
    "a coordinate on the command line that no arm and no place of a cell has",
    """
Angles go up to 36,000 degrees (a hundred turns) either way, lengths up to 100,000 mm (100 m), as positions in
cell files do. A larger number, or none (`nan`, `inf`), comes from a slip of the pen or a failed computation:
what it leaves behind the full turns would mean nothing. A joint that turns has degrees (or `rad`), one that
slides millimetres (or `cm`, `m`); without a unit numbers are degrees and millimetres.
""",
    Category.USAGE,
)


class CoordinateError(RopsimError):
    """A coordinate that no arm and no place of a cell has."""


@frozen_dataclass
class Coordinate:
    """A number of the command line: its name, kind, and value [deg | mm]."""

    name: str
    kind: JointType
    value: float


def joint_coordinates(robot: RobotModel, given: Iterable[tuple[float, str]]) -> list[Coordinate]:
    """Return the coordinates of the joints of a robot; one value each [deg | mm], with its unit or none.

    Raises:
        CoordinateError: U903, a joint that turns has a length, or one that slides an angle.
    """
    found = []
    for joint, (value, unit) in zip(robot.axis_joints, given, strict=True):
        turns = joint.measure is JointType.REVOLUTE
        if unit and unit != ("deg" if turns else "mm"):
            moves = "turns, its unit is deg" if turns else "slides, its unit is mm"
            message = f"`{unit}` for joint `{joint.name}`, which {moves}"
            raise CoordinateError(BEYOND_SENSE.at(None, message, hint="give the unit of this axis"))
        found.append(Coordinate(f"joint `{joint.name}`", joint.measure, value))
    return found


def check_coordinates(given: Iterable[Coordinate]) -> None:
    """Refuse coordinates beyond sense.

    Raises:
        CoordinateError: U903, one is.
    """
    for one in given:
        most = FARTHEST[one.kind]
        if not abs(one.value) <= most:
            unit = "°" if one.kind is JointType.REVOLUTE else " mm"
            found = f"{one.value:g}{unit}" if math.isfinite(one.value) else f"{one.value}"
            message = f"{one.name} is {found}, allowed is up to {most:,.0f}{unit} either way"
            hint = "angles are in degrees, lengths in mm: check the digits and the exponent"
            raise CoordinateError(BEYOND_SENSE.at(None, message, hint=hint))


def shown(value: float, decimals: int) -> float:
    """Return a number rounded for printing, without a negative zero."""
    return round(float(value), decimals) + 0.0


def display(kind: JointType) -> tuple[float, str]:
    """Return the factor from a joint coordinate [rad | m] to its printed number, and the unit."""
    return (math.degrees(1.0), "°") if kind is JointType.REVOLUTE else (1e3, "mm")
