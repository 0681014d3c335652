"""A supply of oil with an accumulator, at which the valves of several axes are."""

from ropsim.core import frozen_dataclass

ATMOSPHERE = 1.01325e5
"""Pressure of the air [Pa], from which pressures of oil are counted."""


@frozen_dataclass
class HydraulicSupply:
    """A pump with an accumulator and a relief valve; drives with equal records are at one supply.

    Its pressure p falls where valves take more than the pump gives: (V_l/β + C_g)·p' is Q_pump - Q_relief -
    ΣQ. The gas of the accumulator keeps (p + p_air)·V^n, so V = V_0·((p_0 + p_air)/(p + p_air))^(1/n) and
    C_g = V/(n·(p + p_air)) above the precharge p_0; below it the accumulator is empty and C_g is 0. The
    bladder leaves its seat over `SEAT`. The pump gives Q_p up to a band below its set pressure p_s, less and
    less within it and nothing at p_s, as one that is regulated by pressure. The relief valve opens at p_r and
    lets Q_p through at 1.1·p_r (H. E. Merritt: Hydraulic Control Systems, Wiley 1967, chapter 11; M. Jelali,
    A. Kroll: Hydraulic Servo-systems, Springer 2003, chapter 4). p_s, the pressure of the return and β are
    those of the drives at the supply.

    Attributes:
        name: of the supply.
        gas_volume: V_0, of the gas at its precharge [m³].
        precharge: p_0, over that of the air [Pa].
        pump_flow: Q_p, most flow of the pump [m³/s].
        line_volume: V_l, of the oil between pump and valves [m³].
        relief_pressure: p_r [Pa], more than p_s.
        pump_band: below p_s, over which the pump goes over to no flow [Pa].
        exponent: n, 1 where the gas keeps its temperature, 1.4 where nitrogen keeps its heat.
    """

    name: str
    gas_volume: float
    precharge: float
    pump_flow: float
    line_volume: float
    relief_pressure: float
    pump_band: float = 5e5
    exponent: float = 1.4


SEAT = 1e5
"""Rise of pressure over the precharge over which the bladder of an accumulator leaves its seat [Pa]."""

SUPPLY_NUMBERS = (
    "gas_volume",
    "precharge",
    "pump_flow",
    "line_volume",
    "relief_pressure",
    "pump_band",
    "exponent",
)
"""Numbers of a supply, in the order of its formulas and of its entity in NIROX."""
