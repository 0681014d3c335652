"""A ball screw: a rigid gear whose efficiency depends on the direction in which power flows.

J. F. Cuttino, T. A. Dow, B. F. Knight: Analytical and experimental identification of nonlinearities in a
single-nut, preloaded ball screw, ASME J. Mech. Design 119 (1997), 15-19; DIN 69051-4 for both efficiencies.
"""

import numpy as np

from ropsim.codegen import Scalar, maximum, tanh
from ropsim.core import frozen_dataclass
from ropsim.dynamics.drives.block import (
    Carried,
    Movement,
    Numbers,
    Recorded,
    Shaft,
    Steady,
    TransmissionBlock,
)
from ropsim.model import BallScrew
from ropsim.spatial import Array

SMOOTHING = 5e-3
"""Speed of the nut over which the losses of its threads turn round [m/s]."""


@frozen_dataclass
class SteadyScrew(BallScrew):
    """A screw that goes on one way under one load, linear: its nut is pushed with a share of G·τ.

    Attributes:
        share: η₁ where the motor drives, 1/η₂ where the load drives, 1 without losses.
    """

    share: float = 1.0


def share_passed(screw: BallScrew, effort: float, speed: float) -> float:
    """Return the share of G·τ that pushes the nut of a screw in steady motion; 1 at rest.

    Args:
        screw: with its efficiencies.
        effort: at the nut [N]. Without any its oscillations turn it both ways: then the larger share, with
            which a loop has its largest gain, is taken.
        speed: of the nut [m/s].
    """
    if not speed:
        return 1.0
    return screw.efficiency if effort * speed > 0.0 else 1.0 / screw.back_efficiency


def _trace(p: Numbers, states: Numbers, shaft: Shaft) -> Carried:
    """Return the force of the nut, and (J + J_s)·G²; the screw turns at G·q̇."""
    del states
    ratio, efficiency, back, screw = p
    given, motor = shaft.motor(Movement(ratio * shaft.q, ratio * shaft.qd))
    inertia = (shaft.inertia + screw) * (ratio * ratio)
    force = _passed(ratio * motor.torque, shaft.qd, 1.0 - efficiency, 1.0 / back - 1.0)
    rubbing = shaft.friction(ratio, shaft.qd)
    return Carried(force, rubbing, inertia, (*motor.rates, *rubbing.rates), given)


def _trace_steady(p: Numbers, states: Numbers, shaft: Shaft) -> Carried:
    """Return the share of G·τ, and (J + J_s)·G²; the screw turns at G·q̇."""
    del states
    ratio, share, screw = p
    given, motor = shaft.motor(Movement(ratio * shaft.q, ratio * shaft.qd))
    inertia = (shaft.inertia + screw) * (ratio * ratio)
    rubbing = shaft.friction(ratio, shaft.qd)
    return Carried(share * ratio * motor.torque, rubbing, inertia, (*motor.rates, *rubbing.rates), given)


def _passed(force: Scalar, speed: Scalar, driving: Scalar, braking: Scalar) -> Scalar:
    """Return what is left of a force behind the threads, which lose a share of it against the motion."""
    zero, way = force.tracer.constant(0.0), tanh(speed * (1.0 / SMOOTHING))
    ahead, behind = maximum(force, zero), maximum(-force, zero)
    forward, backward = maximum(way, zero), maximum(-way, zero)
    lost = forward * (driving * ahead + braking * behind) - backward * (driving * behind + braking * ahead)
    return force - lost


def threads_slope(screw: BallScrew, effort: float) -> float:
    """Return the slope over the speed, at rest, of what threads lose of an effort at the nut [N·s/m]."""
    return max(1.0 - screw.efficiency, 1.0 / screw.back_efficiency - 1.0) * abs(effort) / SMOOTHING


def _rest(screw: BallScrew, q: float, effort: float) -> Steady:
    del q
    return Steady((), effort / screw.ratio)


def _rest_steady(screw: SteadyScrew, q: float, effort: float) -> Steady:
    del q
    return Steady((), effort / (screw.share * screw.ratio))


def _speed(screw: BallScrew, columns: Recorded) -> Array:
    return np.asarray(screw.ratio * columns["qd"])


BALL_SCREW = TransmissionBlock(
    ("ratio", "efficiency", "back_efficiency", "screw_inertia"),
    ("efficiency", "back_efficiency"),
    (),
    _trace,
    _rest,
    _speed,
)
STEADY_SCREW = TransmissionBlock(
    ("ratio", "share", "screw_inertia"), ("share",), (), _trace_steady, _rest_steady, _speed
)
