"""A DC motor that grows warm: its current and the rises of winding and housing are states.

R. Krishnan: Electric Motor Drives, Prentice Hall 2001; two bodies, as data sheets of servo motors have them.
"""

import numpy as np

from ropsim.codegen import Scalar
from ropsim.dynamics.drives.block import (
    Column,
    MotorBlock,
    Movement,
    Numbers,
    Recorded,
    Steady,
    Torque,
)
from ropsim.model import InputKind, ThermalDcMotor
from ropsim.spatial import Array


def _trace(p: Numbers, states: Numbers, voltage: Scalar, shaft: Movement) -> Torque:
    """Return the torque, and the rates of current, of winding and of housing."""
    constant, back_emf, cold, inductance, _, inner, outer, winding, housing, drift, fade = p
    current, warm, outside = states
    resistance, weaker = cold * (1.0 + drift * warm), 1.0 + fade * outside
    rate = (voltage - resistance * current - back_emf * weaker * shaft.speed) / inductance
    between = warm - outside
    heating = (inner * resistance * (current * current) - between) / winding
    passing = (between * (outer / inner) - outside) / housing
    return Torque(constant * weaker * current, (rate, heating, passing))


def _steady(motor: ThermalDcMotor, torque: float, speed: float) -> Steady:
    """Return the current and voltage of a motor that is as warm as where its run begins."""
    rise = motor.start_rise
    weaker = 1.0 + motor.torque_drift * rise
    current = torque / (motor.torque_constant * weaker)
    resistance = motor.resistance * (1.0 + motor.resistance_drift * rise)
    return Steady((current, rise, rise), resistance * current + motor.back_emf_constant * weaker * speed)


def _power(motor: ThermalDcMotor, columns: Recorded, speed: Array) -> Array:
    """Return R·i² + Ke·i·ω with the constants at its temperatures."""
    current = columns["current"]
    resistance = motor.resistance * (1.0 + motor.resistance_drift * columns["winding_rise"])
    back_emf = motor.back_emf_constant * (1.0 + motor.torque_drift * columns["housing_rise"])
    return np.asarray(current * (resistance * current + back_emf * speed))


THERMAL_MOTOR = MotorBlock(
    takes=InputKind.VOLTAGE,
    numbers=(
        "torque_constant",
        "back_emf_constant",
        "resistance",
        "inductance",
        "rotor_inertia",
        "winding_thermal_resistance",
        "housing_thermal_resistance",
        "winding_time_constant",
        "housing_time_constant",
        "resistance_drift",
        "torque_drift",
    ),
    positive=(
        "torque_constant",
        "resistance",
        "inductance",
        "winding_thermal_resistance",
        "housing_thermal_resistance",
        "winding_time_constant",
        "housing_time_constant",
    ),
    states=(
        Column("current", "A", "motor current"),
        Column("winding_rise", "K", "temperature of the winding over that of the surroundings"),
        Column("housing_rise", "K", "temperature of the housing over that of the surroundings"),
    ),
    trace=_trace,
    inertia=lambda p: p[4],
    steady=_steady,
    pole=lambda motor: float(motor.resistance / motor.inductance),
    power=_power,
)
