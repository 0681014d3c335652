"""A gear that twists: the motor has a coordinate and a speed of its own.

M. W. Spong: Modeling and control of elastic joint robots, ASME J. Dyn. Sys. Meas. Control 109 (1987),
310-319: a spring lies between rotor and link, and the turning of the rotor with its link is left out.
"""

from ropsim.dynamics.drives.block import Carried, Column, Movement, Numbers, Shaft, Steady, TransmissionBlock
from ropsim.model import ElasticGear


def _trace(p: Numbers, states: Numbers, shaft: Shaft) -> Carried:
    """Return the torque of the spring; the states are θ/G and ω/G, motor angle and speed seen at the joint.

    J·G²·d(ω/G)/dt = G·τ - friction(ω/G) - spring. The load of friction is what goes through the spring.
    """
    ratio, stiffness, damping = p
    theta, omega = states
    spring = stiffness * (theta - shaft.q) + damping * (omega - shaft.qd)
    given, motor = shaft.motor(Movement(ratio * theta, ratio * omega))
    inverse = 1.0 / (shaft.inertia * (ratio * ratio))
    rubbing = shaft.friction(ratio, omega)
    rate = (ratio * motor.torque - rubbing.under(spring) - spring) * inverse
    return Carried(spring, None, None, (*motor.rates, omega, rate, *rubbing.rates), given)


def _rest(gear: ElasticGear, q: float, effort: float) -> Steady:
    return Steady((q + effort / gear.stiffness, 0.0), effort / gear.ratio)


ELASTIC_GEAR = TransmissionBlock(
    ("ratio", "stiffness", "damping"),
    ("stiffness",),
    (
        Column("motor_coordinate", "{q}", "motor angle over gear ratio"),
        Column("motor_speed", "{q}/s", "motor speed over gear ratio"),
    ),
    _trace,
    _rest,
)
