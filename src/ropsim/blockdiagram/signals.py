"""Signals of a block diagram: vectors with units, and their roles."""

from enum import StrEnum

from ropsim.core import frozen_dataclass


class Role(StrEnum):
    """Meaning of a signal outside of the diagram.

    References, coordinates, speeds and efforts are those of the axes. Speeds are measured at the motors, over
    the ratios of their gears. States of drives are sensed on the side of the motor; the channel of the signal
    names them, such as `motor_coordinate`. An external signal is that of the cell which its channel names.
    """

    REFERENCE_COORDINATE = "reference_coordinate"
    REFERENCE_SPEED = "reference_speed"
    REFERENCE_ACCELERATION = "reference_acceleration"
    COORDINATE = "coordinate"
    SPEED = "speed"
    EFFORT = "effort"
    DRIVE_STATE = "drive_state"
    EXTERNAL = "external"
    INNER = "inner"
    OUTPUT = "output"


INPUTS = frozenset(Role) - {Role.INNER, Role.OUTPUT}
"""Roles of signals that come from outside."""
CHANNELED = frozenset({Role.DRIVE_STATE, Role.EXTERNAL})
"""Roles of signals that have a channel."""


class Unit(StrEnum):
    """Unit of an element of a signal; `other` stands for any that is not in the list and is not compared."""

    ONE = "one"
    RADIAN = "radian"
    METRE = "metre"
    RADIAN_PER_SECOND = "radian_per_second"
    METRE_PER_SECOND = "metre_per_second"
    RADIAN_PER_SECOND_SQUARED = "radian_per_second_squared"
    METRE_PER_SECOND_SQUARED = "metre_per_second_squared"
    NEWTON_METRE = "newton_metre"
    NEWTON = "newton"
    VOLT = "volt"
    AMPERE = "ampere"
    PASCAL = "pascal"
    OTHER = "other"


TURNING = {
    Role.REFERENCE_COORDINATE: Unit.RADIAN,
    Role.REFERENCE_SPEED: Unit.RADIAN_PER_SECOND,
    Role.REFERENCE_ACCELERATION: Unit.RADIAN_PER_SECOND_SQUARED,
    Role.COORDINATE: Unit.RADIAN,
    Role.SPEED: Unit.RADIAN_PER_SECOND,
    Role.EFFORT: Unit.NEWTON_METRE,
}
"""Units of the quantities of an axis that turns."""
SLIDING = {
    Role.REFERENCE_COORDINATE: Unit.METRE,
    Role.REFERENCE_SPEED: Unit.METRE_PER_SECOND,
    Role.REFERENCE_ACCELERATION: Unit.METRE_PER_SECOND_SQUARED,
    Role.COORDINATE: Unit.METRE,
    Role.SPEED: Unit.METRE_PER_SECOND,
    Role.EFFORT: Unit.NEWTON,
}
"""The same of an axis that slides."""
PER_AXIS = frozenset(TURNING) | {Role.DRIVE_STATE, Role.OUTPUT}
"""Roles of signals with an element for each axis."""


@frozen_dataclass
class Signal:
    """A vector of numbers that changes with time.

    Attributes:
        name: unique in its diagram.
        size: number of its elements.
        units: one for all elements, or one for each.
        role: outside of the diagram.
        channel: of a drive state or of a signal of the cell; else empty.
    """

    name: str
    size: int
    units: tuple[Unit, ...]
    role: Role = Role.INNER
    channel: str = ""

    def unit(self, element: int) -> Unit:
        """Return the unit of an element, counted from 0."""
        return self.units[element] if len(self.units) > 1 else self.units[0]
