"""The keys that all sensors of a cell file have: steps, noise, rate and delay."""

import math

from ropsim.cellfile.diagnostics import ROUNDED_RATE
from ropsim.core import frozen_dataclass
from ropsim.model import SensorErrors
from ropsim.tomltext import TIME, Quantity, TomlTable

MOST_BITS = 52
MOST_RATE = 1e6  # [Hz]
_SAME_RATE = 5e-4
_DELAY = TIME.within(0.0, 1.0)


@frozen_dataclass
class SensorTiming:
    """When a sensor measures and tells.

    Attributes:
        period: between two samples [s]; 0 for each control tick.
        delay: [s].
    """

    period: float
    delay: float


def read_timing(table: TomlTable, most_rate: float = MOST_RATE) -> SensorTiming:
    """Return what `rate` and `delay` of a sensor say.

    Args:
        table: of the sensor.
        most_rate: samples per second at the most [Hz].
    """
    rate = table.number("rate", Quantity("Hz", 1.0, 1.0, most_rate), 0.0)
    return SensorTiming(1.0 / rate if rate else 0.0, table.number("delay", _DELAY, 0.0))


def note_rounded(table: TomlTable, period: float, control_hz: float) -> None:
    """Note a rate that the control rate is no whole multiple of (X933).

    Args:
        table: of the sensor.
        period: between two samples [s]; 0 for each control tick.
        control_hz: control ticks per second of its station.
    """
    ticks = max(1, round(period * control_hz))
    if period and abs(period * control_hz / ticks - 1.0) > _SAME_RATE:
        message = (
            f"`{table.name_of('rate')}` is {1.0 / period:.6g} Hz, the run has {control_hz / ticks:.6g} Hz: "
            f"samples are {ticks} of the {control_hz:g} control ticks a second apart"
        )
        hint = f"write `rate = {control_hz / ticks:.6g}`"
        table.findings.add(ROUNDED_RATE, table.value_span("rate"), message, hint)


def read_bits(table: TomlTable) -> int:
    """Return the digits of the numbers of a sensor, 0 where the file says nothing."""
    return table.integer("bits", 1, MOST_BITS, 0)


def read_errors(
    table: TomlTable, quantity: Quantity, ends: tuple[float, float], most_rate: float
) -> SensorErrors:
    """Return what a sensor does to the quantity that it measures.

    Args:
        table: of the sensor.
        quantity: unit and range of steps and noise.
        ends: least and greatest number [SI]; where they are not finite, the key `range` is needed for `bits`.
        most_rate: samples per second at the most [Hz].
    """
    least, most = ends
    step, noise = (table.number(key, quantity, 0.0) for key in ("step", "noise"))
    bits, timing = read_bits(table), read_timing(table, most_rate)
    if bits and not math.isfinite(most - least):
        table.require("range")
    elif bits and "step" not in table:
        step = (most - least) / 2.0**bits
    bound = most if least == -most and math.isfinite(most) else 0.0
    return SensorErrors(step, noise, timing.period, timing.delay, bound)
