"""Dimensions and units: the dimension of a number, and the size of a unit in SI units."""

import math
from dataclasses import replace

from ropsim.core import frozen_dataclass

Dimension = tuple[int, int, int, int, int, int]
"""Exponents of metre, kilogram, second, ampere, radian and share of a limit."""

NUMBER: Dimension = (0, 0, 0, 0, 0, 0)
LENGTH: Dimension = (1, 0, 0, 0, 0, 0)
MASS: Dimension = (0, 1, 0, 0, 0, 0)
TIME: Dimension = (0, 0, 1, 0, 0, 0)
CURRENT: Dimension = (0, 0, 0, 1, 0, 0)
ANGLE: Dimension = (0, 0, 0, 0, 1, 0)
SHARE: Dimension = (0, 0, 0, 0, 0, 1)
SPEED: Dimension = (1, 0, -1, 0, 0, 0)
ACCELERATION: Dimension = (1, 0, -2, 0, 0, 0)
ANGULAR_SPEED: Dimension = (0, 0, -1, 0, 1, 0)
ANGULAR_ACCELERATION: Dimension = (0, 0, -2, 0, 1, 0)
FORCE: Dimension = (1, 1, -2, 0, 0, 0)
TORQUE: Dimension = (2, 1, -2, 0, 0, 0)
VOLTAGE: Dimension = (2, 1, -3, -1, 0, 0)

_NAMES = {
    NUMBER: "number",
    LENGTH: "length",
    MASS: "mass",
    TIME: "time",
    CURRENT: "current",
    ANGLE: "angle",
    SHARE: "share",
    SPEED: "speed",
    ACCELERATION: "acceleration",
    ANGULAR_SPEED: "angular speed",
    ANGULAR_ACCELERATION: "angular acceleration",
    FORCE: "force",
    TORQUE: "torque",
    VOLTAGE: "voltage",
}
_SYMBOLS = ("m", "kg", "s", "A", "rad", "%")
_BASES = (LENGTH, MASS, TIME, CURRENT, ANGLE, SHARE)
_MASS_FIRST = (1, 0, 2, 3, 4, 5)
_DEGREE = math.pi / 180.0

UNITS: dict[str, tuple[Dimension, float]] = {
    "mm": (LENGTH, 0.001),
    "cm": (LENGTH, 0.01),
    "m": (LENGTH, 1.0),
    "inch": (LENGTH, 0.0254),
    "deg": (ANGLE, _DEGREE),
    "rad": (ANGLE, 1.0),
    "s": (TIME, 1.0),
    "ms": (TIME, 0.001),
    "min": (TIME, 60.0),
    "kg": (MASS, 1.0),
    "g": (MASS, 0.001),
    "N": (FORCE, 1.0),
    "Nm": (TORQUE, 1.0),
    "V": (VOLTAGE, 1.0),
    "mA": (CURRENT, 0.001),
    "%": (SHARE, 0.01),
    "mm/s": (SPEED, 0.001),
    "cm/s": (SPEED, 0.01),
    "m/s": (SPEED, 1.0),
    "deg/s": (ANGULAR_SPEED, _DEGREE),
    "rad/s": (ANGULAR_SPEED, 1.0),
    "mm/s2": (ACCELERATION, 0.001),
    "cm/s2": (ACCELERATION, 0.01),
    "m/s2": (ACCELERATION, 1.0),
    "deg/s2": (ANGULAR_ACCELERATION, _DEGREE),
    "rad/s2": (ANGULAR_ACCELERATION, 1.0),
}
"""Dimension and SI factor of every unit; exact by definition (inch: 25.4 mm)."""


_UNITS_OF = {
    dimension: tuple(unit for unit, (other, _) in UNITS.items() if other == dimension)
    for dimension, _ in UNITS.values()
}
"""The units of each dimension, in order."""


@frozen_dataclass
class UnitSystem:
    """The units of bare numbers.

    Attributes:
        length: metres per unit.
        angle: radians per unit.
        time: seconds per unit.
        others: dimension -> SI factor, for units given outright, such as `mm/s`.
        names_time: whether the text says that times are in another unit than seconds.
    """

    length: float
    angle: float
    time: float = 1.0
    others: tuple[tuple[Dimension, float], ...] = ()
    names_time: bool = False

    def factor(self, dimension: Dimension) -> float:
        """Return how many SI units a bare number of `dimension` counts.

        Speeds and accelerations follow from length, angle and time; everything else is SI.
        """
        if not self.others:
            if dimension == LENGTH:
                return float(self.length)
            if dimension == ANGLE:
                return float(self.angle)
        for known, factor in self.others:
            if known == dimension:
                return factor
        metre, kilogram, second, ampere, radian, share = dimension
        if kilogram or ampere or share:
            return 1.0
        return float(self.length**metre * self.time**second * self.angle**radian)

    def name(self, dimension: Dimension) -> str:
        """Return the unit that a bare number of `dimension` counts, empty where it has no name."""
        if dimension not in _UNITS_OF:
            return ""
        factor = self.factor(dimension)
        return next((unit for unit in _UNITS_OF[dimension] if math.isclose(UNITS[unit][1], factor)), "")

    def composed(self, dimension: Dimension) -> tuple[float, str]:
        """Return factor and name of the product of units of a dimension without one of its own, as `mm2`.

        Length, time and angle are in the units of this system, all else in SI units.
        """
        factor, above, below = 1.0, list[str](), list[str]()
        for place in _MASS_FIRST:
            exponent, base = dimension[place], _BASES[place]
            if not exponent:
                continue
            unit = self.name(base) or _SYMBOLS[place]
            factor *= (UNITS[unit][1] if unit in UNITS else 1.0) ** exponent
            power = str(abs(exponent)) if abs(exponent) > 1 else ""
            (above if exponent > 0 else below).append(unit + power)
        name, divisor = "·".join(above) or "1", "·".join(below)
        if len(below) > 1:
            divisor = f"({divisor})"
        return factor, f"{name}/{divisor}" if below else name

    def using(self, unit: str) -> "UnitSystem":
        """Return this system with `unit` for its dimension."""
        dimension, factor = UNITS[unit]
        if dimension == LENGTH:
            return replace(self, length=factor)
        if dimension == ANGLE:
            return replace(self, angle=factor)
        if dimension == TIME:
            return replace(self, time=factor, names_time=factor != 1.0)
        return replace(self, others=((dimension, factor), *self.others))


SI = UnitSystem(1.0, 1.0)
"""Metres, radians, seconds."""


def dimension_name(dimension: Dimension) -> str:
    """Return the word for a dimension, or its SI unit where there is none."""
    known = _NAMES.get(dimension)
    if known:
        return known
    parts = [f"{s}{e if e != 1 else ''}" for s, e in zip(_SYMBOLS, dimension, strict=True) if e]
    return "quantity in " + "·".join(parts)


def product(a: Dimension, b: Dimension) -> Dimension:
    """Return the dimension of a product."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3], a[4] + b[4], a[5] + b[5])


def quotient(a: Dimension, b: Dimension) -> Dimension:
    """Return the dimension of a quotient."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3], a[4] - b[4], a[5] - b[5])


def root(dimension: Dimension) -> Dimension | None:
    """Return the dimension of a square root, None where an exponent is odd."""
    if any(e % 2 for e in dimension):
        return None
    m, kg, s, a, r, p = (e // 2 for e in dimension)
    return (m, kg, s, a, r, p)
