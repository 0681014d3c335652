"""Friction of a gear that grows with the torque that it transmits, without states.

P. Hamon, M. Gautier, P. Garrec: Dynamic identification of robots with a dry friction model depending on load
and velocity, IROS 2010, 6187-6193. The load is the torque of the drive at the joint, for which forward and
inverse dynamics can be solved without a search.
"""

from math import isfinite

from ropsim.codegen import Scalar, tanh
from ropsim.dynamics.drives.block import FrictionBlock, Numbers, Rubbing, Steepness
from ropsim.model import LoadFriction


def _sliding(p: Numbers, ratio: Scalar, qd: Scalar) -> Rubbing:
    """Return B·G²·q̇ + |G|·Tc·tanh(q̇/v_s), and the share μ·tanh(q̇/v_s) of the load."""
    viscous, coulomb, load_share, smoothing = p
    shape = tanh(qd * (1.0 / smoothing))
    return Rubbing(viscous * (ratio * ratio) * qd + abs(ratio) * coulomb * shape, load_share * shape)


def _trace(p: Numbers, states: Numbers, ratio: Scalar, qd: Scalar) -> Rubbing:
    del states
    return _sliding(p, ratio, qd)


def _steady(friction: LoadFriction, speed: float) -> tuple[float, ...]:
    del friction, speed
    return ()


def _steepness(friction: LoadFriction, ratio: float, effort: float) -> Steepness:
    """Return B·G² + (|G|·Tc + μ·|τ|)/v_s under the largest effort, where that has a limit."""
    load = friction.load_share * effort if isfinite(effort) else 0.0
    dry = abs(ratio) * friction.coulomb + load
    return Steepness(ratio**2 * friction.viscous + dry / friction.smoothing_speed)


LOAD_FRICTION = FrictionBlock(
    numbers=("viscous", "coulomb", "load_share", "smoothing_speed"),
    states=(),
    trace=_trace,
    sliding=_sliding,
    steady=_steady,
    steepness=_steepness,
)
