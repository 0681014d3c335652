"""Quantities at the edge: unit as the user writes it, factor to SI and the range that is allowed."""

import math
from dataclasses import replace

from ropsim.core import frozen_dataclass
from ropsim.model import JointType

_METRES = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "inch": 0.0254}
_RADIANS = {"deg": math.pi / 180.0, "rad": 1.0}

_MOST = {JointType.PRISMATIC: (20.0, 1e3, 1e5), JointType.REVOLUTE: (100.0, 1e4, 1e6)}
"""Of an axis [m/s, m/s², m/s³ | rad/s, rad/s², rad/s³]."""

_TWO_TURNS = 4.0 * math.pi + 1e-9  # 720° must pass in spite of rounding

LENGTH_UNITS = tuple(_METRES)
ANGLE_UNITS = tuple(_RADIANS)


@frozen_dataclass
class Quantity:
    """A sort of number.

    Attributes:
        unit: as messages show it, empty for a pure number.
        scale: SI units per unit of the file.
        low: least value allowed [SI].
        high: greatest value allowed [SI].
    """

    unit: str
    scale: float
    low: float
    high: float

    def within(self, low: float, high: float) -> "Quantity":
        """Return the same quantity with another range [SI]."""
        return replace(self, low=low, high=high)

    def show(self, value: float) -> str:
        """Return `value`, in units of the file, as text with its unit."""
        return f"{value:.6g} {self.unit}".rstrip()

    @property
    def allowed(self) -> str:
        """Return the range as text, in units of the file."""
        return f"{self.low / self.scale:.6g} to {self.show(self.high / self.scale)}"


NUMBER = Quantity("", 1.0, -1e9, 1e9)
SHARE = Quantity("", 1.0, 1e-3, 1.0)
MASS = Quantity("kg", 1.0, 0.0, 1e4)
MOMENT = Quantity("kg·m²", 1.0, -1e5, 1e5)
TIME = Quantity("s", 1.0, 0.0, 1e5)
DWELL = TIME.within(0.0, 60.0)


@frozen_dataclass
class Units:
    """The units of a file.

    Attributes:
        length: name of the unit of length.
        angle: name of the unit of angle.
    """

    length: str = "mm"
    angle: str = "deg"

    @property
    def position(self) -> Quantity:
        """Return a coordinate: up to 100 m either way."""
        return Quantity(self.length, metres(self.length), -100.0, 100.0)

    @property
    def extent(self) -> Quantity:
        """Return an edge, radius or distance: 1 µm to 100 m."""
        return Quantity(self.length, metres(self.length), 1e-6, 100.0)

    def rate(self, type_: JointType, order: int) -> Quantity:
        """Return the speed, acceleration or jerk (order 1, 2, 3) of one axis, up to the common bound."""
        most = _MOST[type_][order - 1]
        return (self.path if type_ is JointType.PRISMATIC else self.orientation)(order, most)

    @property
    def turn(self) -> Quantity:
        """Return an angle: up to two turns either way."""
        return Quantity(self.angle, radians(self.angle), -_TWO_TURNS, _TWO_TURNS)

    def path(self, order: int, high: float) -> Quantity:
        """Return the derivative of a length: order 1 is a speed, 2 an acceleration, 3 a jerk; above 0."""
        return Quantity(f"{self.length}/s{_POWERS[order]}", metres(self.length), 1e-6, high)

    def orientation(self, order: int, high: float) -> Quantity:
        """Return the derivative of an angle, like `path`."""
        return Quantity(f"{self.angle}/s{_POWERS[order]}", radians(self.angle), 1e-6, high)


_POWERS = {1: "", 2: "²", 3: "³"}


def metres(unit: str) -> float:
    """Return the metres in one unit of length.

    Raises:
        KeyError: `unit` is none of `LENGTH_UNITS`.
    """
    return _METRES[unit]


def radians(unit: str) -> float:
    """Return the radians in one unit of angle.

    Raises:
        KeyError: `unit` is none of `ANGLE_UNITS`.
    """
    return _RADIANS[unit]
