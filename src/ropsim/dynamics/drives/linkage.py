"""A cylinder between two links: its force has a lever that changes as the joint turns.

The triangle of pins and axis and its derivatives: `model.Linkage`. Mass that moves with the rod has the
energy m·(G·q̇)²/2, so that the joint feels m·G² as inertia and m·G·G'·q̇² besides (Lagrange).
"""

import numpy as np

from ropsim.codegen import Scalar, cos, sin, sqrt
from ropsim.dynamics.drives.block import (
    Carried,
    Movement,
    Numbers,
    Recorded,
    Shaft,
    Steady,
    TransmissionBlock,
)
from ropsim.model import Linkage
from ropsim.spatial import Array


def _trace(p: Numbers, states: Numbers, shaft: Shaft) -> Carried:
    """Return G·F and m·G²; the rod moves at G·q̇, and G' = r·s·cos(q + φ)/ℓ - G²/ℓ."""
    del states
    _, product, squares, angle, retracted = p
    turn = shaft.q + angle
    lever, length = product * cos(turn), sqrt(squares - 2.0 * product * cos(turn))
    inverse: Scalar = 1.0 / length
    ratio = product * sin(turn) * inverse
    bend = (lever - ratio * ratio) * inverse
    given, motor = shaft.motor(Movement(length - retracted, ratio * shaft.qd))
    turned = shaft.inertia * ratio * bend * (shaft.qd * shaft.qd)
    rubbing = shaft.friction(ratio, shaft.qd)
    against = rubbing._replace(torque=rubbing.torque + turned)
    inertia, rates = shaft.inertia * (ratio * ratio), (*motor.rates, *rubbing.rates)
    return Carried(ratio * motor.torque, against, inertia, rates, given)


def _rest(gear: Linkage, q: float, effort: float) -> Steady:
    ratio = gear.ratio_at(q)
    return Steady((), effort / ratio if ratio else 0.0)


def _speed(gear: Linkage, columns: Recorded) -> Array:
    """Return the speed of the rod, G·q̇ [m/s]."""
    turn = columns["q"] + gear.angle
    length = np.sqrt(gear.squares - 2.0 * gear.product * np.cos(turn))
    return np.asarray(gear.product * np.sin(turn) / length * columns["qd"])


LINKAGE = TransmissionBlock(
    ("sense", "product", "squares", "angle", "retracted_length"),
    ("product", "retracted_length"),
    (),
    _trace,
    _rest,
    _speed,
)
