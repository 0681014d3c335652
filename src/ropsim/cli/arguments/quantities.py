"""Quantities of the command line: a number, with its unit or without."""

import argparse
import math
import re
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import TypeAlias

Units: TypeAlias = Mapping[str, float]
"""Units and their factors; a number without one has the first."""

_NUMBER = re.compile(r"\s*([+-]?(?:(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|nan|inf))\s*(.*?)\s*", re.DOTALL)
_SHOWN = 40
"""Characters of a wrong text that are repeated."""
_DEGREE = math.degrees(1.0)

FREQUENCY: Units = MappingProxyType({"Hz": 1.0, "kHz": 1e3, "rad/s": 0.5 / math.pi})
MASS: Units = MappingProxyType({"kg": 1.0, "g": 1e-3, "t": 1e3})
TIME: Units = MappingProxyType({"s": 1.0, "ms": 1e-3, "min": 60.0})
LENGTH: Units = MappingProxyType({"mm": 1.0, "cm": 10.0, "m": 1e3})
ANGLE: Units = MappingProxyType({"deg": 1.0, "°": 1.0, "rad": _DEGREE})


def quantity(text: str, what: str, units: Units) -> float:
    """Return a number in the first one of some units.

    Args:
        text: as typed.
        what: its kind, such as `frequency`.
        units: that it may have.

    Raises:
        ArgumentTypeError: no number, or another unit.
    """
    value, unit = _parts(text, what, units)
    found = value * (units[unit] if unit else 1.0)
    if not math.isfinite(found):
        raise argparse.ArgumentTypeError(f"`{text[:_SHOWN]}` is no {what}: it is no number, or too large")
    return found


def reader(what: str, units: Units) -> Callable[[str], float]:
    """Return the function from texts to numbers that `quantity` is for one kind."""
    return lambda text: quantity(text, what, units)


def coordinate(text: str) -> tuple[float, str]:
    """Return an angle [deg] or a length [mm], NaN and infinities too, and its unit, empty for none."""
    return _way(text, "coordinate", "")


def coordinate_of(unit: str) -> Callable[[str], float]:
    """Return the function from texts to coordinates of one kind, `deg` or `mm`, NaN and infinities too."""
    units = {"deg": ANGLE, "mm": LENGTH}[unit]

    def read(text: str) -> float:
        value, found = _parts(text, "angle" if unit == "deg" else "length", units)
        return value * (units[found] if found else 1.0)

    return read


def step(text: str) -> tuple[float, str]:
    """Return a step that is not 0 [deg | mm], and its unit, empty for none."""
    return _not_zero(text, "step", "")


def speed(text: str) -> tuple[float, str]:
    """Return a speed that is not 0 [deg/s | mm/s], and the unit of its way, `deg` or `mm`, empty for none."""
    return _not_zero(text, "speed", "/s")


def band(text: str) -> tuple[float, float]:
    """Return the least and the greatest frequency [Hz] of a range such as `1..50Hz`."""
    first, dots, last = text.partition("..")
    if not dots:
        raise argparse.ArgumentTypeError(f"`{text[:_SHOWN]}` is no range of frequencies such as 1..50Hz")
    low, high = (quantity(one, "frequency", FREQUENCY) for one in (first, last))
    if not 0.0 < low < high:
        raise argparse.ArgumentTypeError(
            f"`{text[:_SHOWN]}` is no range of frequencies: it begins above 0 Hz and ends higher"
        )
    return low, high


def _not_zero(text: str, what: str, behind: str) -> tuple[float, str]:
    value, unit = _way(text, what, behind)
    if not (value and math.isfinite(value)):
        raise argparse.ArgumentTypeError(f"`{text[:_SHOWN]}` is no {what}: it is 0, no number, or too large")
    return value, unit


def _way(text: str, what: str, behind: str) -> tuple[float, str]:
    units = {name + behind: factor for name, factor in {**ANGLE, **LENGTH}.items()}
    value, unit = _parts(text, what, units)
    if not unit:
        return value, ""
    return value * units[unit], "deg" if unit.removesuffix(behind) in ANGLE else "mm"


def _parts(text: str, what: str, units: Units) -> tuple[float, str]:
    """Return the number of a text and its unit, empty for none."""
    found, shown = _NUMBER.fullmatch(text), text[:_SHOWN]
    if found is None:
        example = f"5{next(iter(units), '')}"
        raise argparse.ArgumentTypeError(
            f"`{shown}` is no {what}: a number, with or without a unit: {example}"
        )
    if found[2] and found[2] not in units:
        article = "an" if what[0] in "aeiou" else "a"
        names = f"one of {', '.join(units)}, or none" if units else "none"
        raise argparse.ArgumentTypeError(
            f"`{shown}`: {article} {what} has no unit `{found[2][:_SHOWN]}`, it has {names}"
        )
    return float(found[1]), found[2]
