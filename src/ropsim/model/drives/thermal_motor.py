"""A DC motor that grows warm, and the amplifier that watches it."""

from math import inf, isfinite, sqrt

from ropsim.core import frozen_dataclass

COPPER = 3.93e-3
"""Resistance of copper grows by this share for each kelvin from room temperature on."""


@frozen_dataclass
class GuardedAmplifier:
    """A voltage amplifier with a sensor in the winding of its motor.

    Attributes:
        max_voltage: [V]; the output is clipped to ±max_voltage.
        max_current: [A]; the drive reports when the current exceeds it.
        max_rise: [K] above the surroundings; the drive reports when the winding exceeds it.
    """

    max_voltage: float
    max_current: float
    max_rise: float


@frozen_dataclass
class ThermalDcMotor:
    """A permanent-magnet DC motor whose winding heats its housing, and that the surroundings.

    L·di/dt = u - R·(1 + α·ϑ_w)·i - Ke·(1 + β·ϑ_h)·ω, torque = Kt·(1 + β·ϑ_h)·i. The rises over the
    surroundings have two time constants, as data sheets give them: τ_w·ϑ_w' = R_w·P - (ϑ_w - ϑ_h) with the
    loss P of the winding, and τ_h·ϑ_h' = (ϑ_w - ϑ_h)·R_h/R_w - ϑ_h (R. Krishnan: Electric Motor Drives,
    Prentice Hall 2001).

    Attributes:
        torque_constant: Kt [N·m/A] at the temperature of the surroundings.
        back_emf_constant: Ke [V·s/rad], the same.
        resistance: R [ohm], the same.
        inductance: L [H].
        rotor_inertia: J [kg·m²], rotor and gear input.
        winding_thermal_resistance: R_w from winding to housing [K/W].
        housing_thermal_resistance: R_h from housing to the surroundings [K/W].
        winding_time_constant: τ_w [s].
        housing_time_constant: τ_h [s].
        resistance_drift: α >= 0 [1/K].
        torque_drift: β <= 0 [1/K]; magnets of ferrite have -2e-3, of neodymium -1.1e-3.
        start_rise: of winding and housing where a run begins [K].
    """

    torque_constant: float
    back_emf_constant: float
    resistance: float
    inductance: float
    rotor_inertia: float
    winding_thermal_resistance: float
    housing_thermal_resistance: float
    winding_time_constant: float
    housing_time_constant: float
    resistance_drift: float = COPPER
    torque_drift: float = 0.0
    start_rise: float = 0.0

    def lasting_current(self, rise: float) -> float:
        """Return the current that for ever warms the winding to a rise over the surroundings [A].

        There R·(1 + α·ϑ)·i² leaves it through both thermal resistances, ϑ/(R_w + R_h).
        """
        if not isfinite(rise):
            return inf
        through = self.winding_thermal_resistance + self.housing_thermal_resistance
        return sqrt(rise / (through * self.resistance * (1.0 + self.resistance_drift * rise)))
