"""A gear that twists: the motor has a coordinate and a speed of its own.

M. W. Spong: Modeling and control of elastic joint robots, ASME J. Dyn. Sys. Meas. Control 109 (1987),
310-319: a spring lies between rotor and link, and the turning of the rotor with its link is left out.
"""

import numpy as np

from ropsim.codegen import Scalar
from ropsim.dynamics.drives.block import (
    Carried,
    Column,
    Movement,
    Numbers,
    Recorded,
    Shaft,
    Steady,
    TransmissionBlock,
)
from ropsim.model import Elastic, ElasticGear
from ropsim.spatial import Array

ROTOR_STATES = (
    Column("motor_coordinate", "{q}", "motor angle over gear ratio"),
    Column("motor_speed", "{q}/s", "motor speed over gear ratio"),
)
"""θ/G and ω/G, motor angle and speed seen at the joint."""


def trace_rotor(shaft: Shaft, ratio: Scalar, states: Numbers, effort: Scalar) -> Carried:
    """Return the effect of a rotor with states of its own that brings an effort to the joint.

    J·G²·d(ω/G)/dt = G·τ - friction(ω/G) - effort. The load of friction is that effort.

    Args:
        shaft: both sides of the transmission.
        ratio: G.
        states: `ROTOR_STATES`.
        effort: of what lies between rotor and joint.
    """
    theta, omega = states
    given, motor = shaft.motor(Movement(ratio * theta, ratio * omega))
    inverse = 1.0 / (shaft.inertia * (ratio * ratio))
    rubbing = shaft.friction(ratio, omega)
    rate = (ratio * motor.torque - rubbing.under(effort) - effort) * inverse
    return Carried(effort, None, None, (*motor.rates, omega, rate, *rubbing.rates), given)


def rotor_speed(gear: Elastic, columns: Recorded) -> Array:
    """Return the speed of a rotor with states of its own [rad/s], from its recorded columns."""
    return np.asarray(gear.ratio * columns["motor_speed"])


def _trace(p: Numbers, states: Numbers, shaft: Shaft) -> Carried:
    """Return the torque of the spring, k·(θ/G - q) + d·(ω/G - q̇)."""
    ratio, stiffness, damping = p
    theta, omega = states
    spring = stiffness * (theta - shaft.q) + damping * (omega - shaft.qd)
    return trace_rotor(shaft, ratio, states, spring)


def _rest(gear: ElasticGear, q: float, effort: float) -> Steady:
    return Steady((q + effort / gear.stiffness, 0.0), effort / gear.ratio)


ELASTIC_GEAR = TransmissionBlock(
    ("ratio", "stiffness", "damping"),
    ("stiffness",),
    ROTOR_STATES,
    _trace,
    _rest,
    rotor_speed,
)
