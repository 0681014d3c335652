"""A rigid gear: motor and joint move as one."""

import numpy as np

from ropsim.dynamics.drives.block import (
    Carried,
    Movement,
    Numbers,
    Recorded,
    Shaft,
    Steady,
    TransmissionBlock,
)
from ropsim.model import Gear
from ropsim.spatial import Array


def _trace(p: Numbers, states: Numbers, shaft: Shaft) -> Carried:
    """Return G·τ and J·G²; the motor turns at G·q̇."""
    del states
    (ratio,) = p
    given, motor = shaft.motor(Movement(ratio * shaft.q, ratio * shaft.qd))
    inertia = shaft.inertia * (ratio * ratio)
    effort, rubbing = ratio * motor.torque, shaft.friction(ratio, shaft.qd)
    return Carried(effort, rubbing, inertia, (*motor.rates, *rubbing.rates), given)


def _rest(gear: Gear, q: float, effort: float) -> Steady:
    del q
    return Steady((), effort / gear.ratio)


def _speed(gear: Gear, columns: Recorded) -> Array:
    return np.asarray(gear.ratio * columns["qd"])


GEAR = TransmissionBlock(("ratio",), (), (), _trace, _rest, _speed)
