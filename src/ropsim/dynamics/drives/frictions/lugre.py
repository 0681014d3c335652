"""Friction of bristles that bend until they slip; their bend is a state.

C. Canudas de Wit, H. Olsson, K. J. Åström, P. Lischinsky: A new model for control of systems with friction,
IEEE Trans. Automatic Control 40 (1995), 419-425.
"""

from math import copysign
from math import exp as exponential

from ropsim.codegen import Scalar, exp, tanh
from ropsim.dynamics.drives.block import Column, FrictionBlock, Numbers, Rubbing, Steepness
from ropsim.model import LugreFriction

FASTEST = 2e3
"""Rate [1/s] with which bristles follow their speed at the most. They would do so with λ = σ0·|ω|/g(ω), which
a fast motor makes greater than the rates of all other parts of an arm; λ/(1 + λ/FASTEST) leaves sticking and
steady sliding as they are, and a fixed integration step stable."""


def _trace(p: Numbers, states: Numbers, ratio: Scalar, qd: Scalar) -> Rubbing:
    """Return G·(σ0·z + σ1·z' + B·ω) with ω = G·q̇, and the rate of y = σ0·z/Ts.

    The state y is the share of the breakaway torque that the bristles bear: y' = (σ0·ω/Ts - λ·y)/(1 +
    λ/FASTEST).
    """
    viscous, _, breakaway, _, stiffness, damping, _ = p
    (borne,) = states
    speed = ratio * qd
    decay = stiffness * abs(speed) / _steady_torque(p, speed)
    rate = (speed * (stiffness / breakaway) - decay * borne) / (1.0 + decay * (1.0 / FASTEST))
    torque = breakaway * borne + (breakaway / stiffness * damping) * rate + viscous * speed
    return Rubbing(ratio * torque, rates=(rate,))


def _sliding(p: Numbers, ratio: Scalar, qd: Scalar) -> Rubbing:
    """Return B·G²·q̇ + |G|·g(G·q̇)·tanh(q̇/v_s)."""
    viscous, *_, smoothing = p
    dry = abs(ratio) * _steady_torque(p, ratio * qd)
    return Rubbing(viscous * (ratio * ratio) * qd + dry * tanh(qd * (1.0 / smoothing)))


def _steady_torque(p: Numbers, speed: Scalar) -> Scalar:
    """Return g(ω), the torque of the bristles in steady sliding."""
    _, coulomb, breakaway, stribeck, *_ = p
    share = speed / stribeck
    return coulomb + (breakaway - coulomb) * exp(-(share * share))


def _steady(friction: LugreFriction, speed: float) -> tuple[float, ...]:
    """Return g(ω)/Ts with the sign of the speed; bristles of what has not moved are straight."""
    if speed == 0.0:
        return (0.0,)
    low = exponential(-((speed / friction.stribeck_speed) ** 2))
    sliding = friction.coulomb + (friction.breakaway - friction.coulomb) * low
    return (copysign(sliding / friction.breakaway, speed),)


def _steepness(friction: LugreFriction, ratio: float, effort: float) -> Steepness:
    """Return (B + σ1)·G² and σ0·G²."""
    del effort
    square = ratio**2
    return Steepness(
        square * (friction.viscous + friction.bristle_damping), square * friction.bristle_stiffness
    )


LUGRE_FRICTION = FrictionBlock(
    numbers=(
        "viscous",
        "coulomb",
        "breakaway",
        "stribeck_speed",
        "bristle_stiffness",
        "bristle_damping",
        "smoothing_speed",
    ),
    states=(Column("bristles", "1", "share of the breakaway torque that the bristles of friction bear"),),
    trace=_trace,
    sliding=_sliding,
    steady=_steady,
    steepness=_steepness,
)
