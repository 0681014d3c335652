"""A permanent-magnet DC motor: its current is a state."""

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
from ropsim.model import CurrentLoopMotor, DcMotor, InputKind
from ropsim.spatial import Array


def _trace(p: Numbers, states: Numbers, voltage: Scalar, shaft: Movement) -> Torque:
    """Return Kt·i and di/dt = (u - R·i - Ke·ω) / L."""
    constant, back_emf, resistance, inductance, _ = p
    (current,) = states
    inverse = 1.0 / inductance
    rate = voltage * inverse - current * (resistance * inverse) - shaft.speed * (back_emf * inverse)
    return Torque(current * constant, (rate,))


def _keeping(p: Numbers, current: Scalar, speed: Scalar) -> Scalar:
    """Return R·i + Ke·ω."""
    _, back_emf, resistance, *_ = p
    return resistance * current + back_emf * speed


def _steady(motor: DcMotor, torque: float, speed: float) -> Steady:
    current = torque / motor.torque_constant
    return Steady((current,), motor.resistance * current + motor.back_emf_constant * speed)


def electric_power(motor: DcMotor | CurrentLoopMotor, columns: Recorded, speed: Array) -> Array:
    """Return R·i² + Ke·i·ω: the power u·i of its voltage without d(L·i²/2)/dt, which the winding stores."""
    current = columns["current"]
    return np.asarray(current * (motor.resistance * current + motor.back_emf_constant * speed))


DC_MOTOR = MotorBlock(
    takes=InputKind.VOLTAGE,
    numbers=("torque_constant", "back_emf_constant", "resistance", "inductance", "rotor_inertia"),
    positive=("torque_constant", "resistance", "inductance"),
    states=(Column("current", "A", "motor current"),),
    trace=_trace,
    inertia=lambda p: p[4],
    steady=_steady,
    pole=lambda motor: float(motor.resistance / motor.inductance),
    power=electric_power,
    keeping=_keeping,
)
