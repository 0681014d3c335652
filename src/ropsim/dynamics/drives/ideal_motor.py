"""A source of torque or force without states."""

from math import inf

import numpy as np

from ropsim.codegen import Scalar
from ropsim.dynamics.drives.block import MotorBlock, Movement, Numbers, Recorded, Steady, Torque
from ropsim.model import IdealMotor, InputKind
from ropsim.spatial import Array


def _trace(p: Numbers, states: Numbers, effort: Scalar, shaft: Movement) -> Torque:
    del p, states, shaft
    return Torque(effort, ())


def _steady(motor: IdealMotor, torque: float, speed: float) -> Steady:
    del motor, speed
    return Steady((), torque)


def _pole(motor: IdealMotor) -> float:
    del motor
    return inf


def _power(motor: IdealMotor, columns: Recorded, speed: Array) -> Array:
    """Return the power of its shaft, τ·ω: it has no losses."""
    del motor
    return np.asarray(columns["command"] * speed)


IDEAL_MOTOR = MotorBlock(
    takes=InputKind.EFFORT,
    numbers=("rotor_inertia",),
    positive=(),
    states=(),
    trace=_trace,
    inertia=lambda p: p[0],
    steady=_steady,
    pole=_pole,
    power=_power,
)
