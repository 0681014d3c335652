"""Friction that is larger at low speeds, without states.

B. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit: A survey of models, analysis tools and compensation
methods for the control of machines with friction, Automatica 30 (1994), 1083-1138.
"""

from ropsim.codegen import Scalar, exp, power, tanh
from ropsim.dynamics.drives.block import FrictionBlock, Numbers, Rubbing, Steepness
from ropsim.model import StribeckFriction


def _sliding(p: Numbers, ratio: Scalar, qd: Scalar) -> Rubbing:
    """Return B·G²·q̇ + |G|·(Tc + (Ts - Tc)·exp(-|G·q̇/ω_s|^δ))·tanh(q̇/v_s)."""
    viscous, coulomb, breakaway, stribeck, exponent, smoothing = p
    size = abs(ratio)
    low = exp(-power(size * abs(qd) / stribeck, exponent))
    dry = size * (coulomb + (breakaway - coulomb) * low)
    return Rubbing(viscous * (ratio * ratio) * qd + dry * tanh(qd * (1.0 / smoothing)))


def _trace(p: Numbers, states: Numbers, ratio: Scalar, qd: Scalar) -> Rubbing:
    del states
    return _sliding(p, ratio, qd)


def _steady(friction: StribeckFriction, speed: float) -> tuple[float, ...]:
    del friction, speed
    return ()


def _steepness(friction: StribeckFriction, ratio: float, effort: float) -> Steepness:
    """Return B·G² + |G|·Ts/v_s."""
    del effort
    return Steepness(ratio**2 * friction.viscous + abs(ratio) * friction.breakaway / friction.smoothing_speed)


STRIBECK_FRICTION = FrictionBlock(
    numbers=("viscous", "coulomb", "breakaway", "stribeck_speed", "exponent", "smoothing_speed"),
    states=(),
    trace=_trace,
    sliding=_sliding,
    steady=_steady,
    steepness=_steepness,
)
