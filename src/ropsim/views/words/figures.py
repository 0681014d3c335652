"""Numbers for people: degrees and millimetres, the sign for "unknown", sensible digits."""

import math
from collections.abc import Iterable

from ropsim.core import frozen_dataclass
from ropsim.flow import AxisType

UNKNOWN = "–"
"""Placeholder for an unknown number."""
WITHOUT_DRIVES = f"{UNKNOWN}, without drives"
"""Placeholder for figures of an arm that follows its reference exactly."""


@frozen_dataclass
class Scale:
    """How a quantity is shown: SI value times `factor` in `unit`."""

    factor: float
    unit: str


DEGREES = Scale(180.0 / math.pi, "°")
DEGREES_PER_SECOND = Scale(180.0 / math.pi, "°/s")
MILLIMETRES = Scale(1000.0, "mm")
MILLIMETRES_PER_SECOND = Scale(1000.0, "mm/s")
TORQUE = Scale(1.0, "N·m")
FORCE = Scale(1.0, "N")
AMPERE = Scale(1.0, "A")
PERCENT = Scale(100.0, "%")
METRES = Scale(1.0, "m")
WATT = Scale(1.0, "W")
WATT_HOURS = Scale(1.0 / 3600.0, "Wh")


def coordinate_scale(joint: AxisType) -> Scale:
    """Return how coordinates of a joint of this kind are shown."""
    return DEGREES if joint is AxisType.REVOLUTE else MILLIMETRES


def speed_scale(joint: AxisType) -> Scale:
    """Return how speeds of a joint of this kind are shown."""
    return DEGREES_PER_SECOND if joint is AxisType.REVOLUTE else MILLIMETRES_PER_SECOND


def effort_scale(joint: AxisType) -> Scale:
    """Return how torques or forces of a joint of this kind are shown."""
    return TORQUE if joint is AxisType.REVOLUTE else FORCE


def joined_units(scales: Iterable[Scale]) -> str:
    """Return the units that a table column holds, such as `°` or `° or mm`."""
    return " or ".join(dict.fromkeys(scale.unit for scale in scales))


def fixed(value: float, scale: Scale, decimals: int) -> str:
    """Return a number with fixed decimals and without its unit; `–` where it is not finite."""
    if not math.isfinite(value):
        return UNKNOWN
    text = f"{value * scale.factor:.{decimals}f}"
    return text.lstrip("-") if float(text) == 0.0 else text


def with_unit(value: float, scale: Scale, decimals: int) -> str:
    """Return a number with fixed decimals and its unit; `–` where it is not finite."""
    if not math.isfinite(value):
        return UNKNOWN
    space = "" if scale.unit == "°" else "\u00a0"
    return f"{fixed(value, scale, decimals)}{space}{scale.unit}"


def energy(joules: float) -> str:
    """Return an energy [J] with three digits in Wh, in kWh from 1 kWh on; `–` where it is not finite."""
    hours = joules * WATT_HOURS.factor
    return _digits(hours, "Wh") if abs(hours) < 1e3 else _digits(hours * 1e-3, "kWh")


def power(watts: float) -> str:
    """Return a power [W] with three digits, in kW from 1 kW on; `–` where it is not finite."""
    return _digits(watts, "W") if abs(watts) < 1e3 else _digits(watts * 1e-3, "kW")


def digits(value: float) -> str:
    """Return a number with three digits and without exponent; `–` where it is not finite."""
    if not math.isfinite(value):
        return UNKNOWN
    rounded = float(f"{value:.2e}")
    if abs(rounded) < 0.5e-5:
        return "0"
    size = math.floor(math.log10(abs(rounded)))
    return f"{rounded:.{min(max(2 - size, 0), 5)}f}"


def _digits(value: float, unit: str) -> str:
    return f"{digits(value)}\u00a0{unit}" if math.isfinite(value) else UNKNOWN


def seconds(value: float) -> str:
    """Return a time in seconds with two decimals, `–` where it is not finite."""
    return fixed(value, METRES, 2)


def percent(share: float) -> str:
    """Return a share in whole percent, `–` where it is not finite."""
    return f"{share * 100.0:.0f}\u00a0%" if math.isfinite(share) else UNKNOWN
