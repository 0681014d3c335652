"""A supply of oil with an accumulator: what its pressure does while valves take oil from it."""

from collections.abc import Sequence

import numpy as np

from ropsim.codegen import Scalar, maximum, minimum, power
from ropsim.dynamics.drives.block import Column, Numbers
from ropsim.model import ATMOSPHERE, SEAT, SUPPLY_NUMBERS, Drive, Hydraulic, HydraulicSupply
from ropsim.spatial import Array

SUPPLY = Column("supply_pressure", "Pa", "pressure of the supply that the valve is at", 0.0)
"""The state of a supply with an accumulator; every drive that is at it records it.

What it cannot be below is a number of each drive, of which the 0 here takes the place.
"""

_RELIEF_BAND = 0.1
"""Rise of pressure over that at which the relief valve lets all of the pump through, over the latter."""

SUPPLY_SIZE = len(SUPPLY_NUMBERS) + 2
"""How many numbers a supply has: pump pressure and bulk modulus of its drives are behind its own."""


def supply_groups(drives: Sequence[Drive]) -> tuple[tuple[int, ...], ...]:
    """Return for each supply the numbers of the drives at it, from 0; drives of equal records share one."""
    found: dict[HydraulicSupply, list[int]] = {}
    for axis, drive in enumerate(drives):
        if drive.supply is not None:
            found.setdefault(drive.supply, []).append(axis)
    return tuple(map(tuple, found.values()))


def supply_numbers(drives: Sequence[Drive]) -> Array:
    """Return the numbers of all supplies, `SUPPLY_SIZE` each, those of the first drive at it among them."""
    rows = []
    for axes in supply_groups(drives):
        motor, supply = drives[axes[0]].motor, drives[axes[0]].supply
        if isinstance(motor, Hydraulic):
            own = [float(getattr(supply, name)) for name in SUPPLY_NUMBERS]
            rows.append([*own, float(motor.supply_pressure), float(motor.bulk_modulus)])
    return np.array(rows).ravel()


def trace_supply(numbers: Numbers, pressure: Scalar, taken: Sequence[Scalar]) -> Scalar:
    """Return the rate of the pressure of a supply [Pa/s].

    Args:
        numbers: of the supply.
        pressure: p [Pa].
        taken: what each valve takes from it [m³/s].
    """
    gas, precharge, most, line, relief, band, exponent, full, bulk = numbers
    zero, one = pressure.tracer.constant(0.0), pressure.tracer.constant(1.0)
    over = maximum(pressure - precharge, zero)
    whole = precharge + over + ATMOSPHERE
    volume = gas * power((precharge + ATMOSPHERE) / whole, 1.0 / exponent)
    off_seat = minimum(over * (1.0 / SEAT), one)
    capacity = line / bulk + off_seat * volume / (exponent * whole)
    given = most * minimum(maximum((full - pressure) / band, zero), one)
    relieved = most * maximum(pressure - relief, zero) / (_RELIEF_BAND * relief)
    net = given - relieved
    for flow in taken:
        net = net - flow
    return net / capacity
