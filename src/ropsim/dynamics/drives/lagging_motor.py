"""A source of torque or force that follows its command with a lag: its torque is a state."""

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
from ropsim.model import InputKind, LaggingMotor
from ropsim.spatial import Array


def _trace(p: Numbers, states: Numbers, effort: Scalar, shaft: Movement) -> Torque:
    """Return τ and dτ/dt = ω_c·(command - τ)."""
    del shaft
    (torque,) = states
    return Torque(torque, (p[1] * (effort - torque),))


def _steady(motor: LaggingMotor, torque: float, speed: float) -> Steady:
    del motor, speed
    return Steady((torque,), torque)


def _power(motor: LaggingMotor, columns: Recorded, speed: Array) -> Array:
    """Return the power of its shaft, τ·ω: it has no losses."""
    del motor
    return np.asarray(columns["motor_torque"] * speed)


LAGGING_MOTOR = MotorBlock(
    takes=InputKind.EFFORT,
    numbers=("rotor_inertia", "bandwidth"),
    positive=("bandwidth",),
    states=(Column("motor_torque", "{tau}", "torque or force that the motor gives"),),
    trace=_trace,
    inertia=lambda p: p[0],
    steady=_steady,
    pole=lambda motor: float(motor.bandwidth),
    power=_power,
)
