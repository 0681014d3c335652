"""Viscous and Coulomb friction of a drive as torque at the joint."""

from ropsim.codegen import Scalar, tanh
from ropsim.dynamics.drives.block import FrictionBlock, Numbers, Rubbing, Steepness
from ropsim.model import Friction


def _sliding(p: Numbers, ratio: Scalar, qd: Scalar) -> Rubbing:
    """Return the torque that the drive spends on friction at joint speed `qd` [N·m | N].

    It is B·G²·q̇ + |G|·Tc·tanh(q̇/v_s), where Tc is the Coulomb torque of the direction of motion, taken as a
    magnitude; friction itself acts on the joint with the opposite sign. Near standstill tanh takes the place
    of the jump, so that the equations can be integrated with a fixed step. P. I. Corke, B.
    Armstrong-Hélouvry: A search for consensus among model parameters reported for the PUMA 560 robot, ICRA
    1994, have both directions.
    """
    viscous, positive, negative, smoothing = p
    forward, backward, size = abs(positive), abs(negative), abs(ratio)
    shape = tanh(qd * (1.0 / smoothing))
    # mean·x + half·|x| is Tc+·x for x > 0 and Tc-·x for x < 0, without a branch
    mean, half = size * (0.5 * (forward + backward)), size * (0.5 * (forward - backward))
    return Rubbing(viscous * (ratio * ratio) * qd + (mean * shape + half * abs(shape)))


def _trace(p: Numbers, states: Numbers, ratio: Scalar, qd: Scalar) -> Rubbing:
    del states
    return _sliding(p, ratio, qd)


def _steady(friction: Friction, speed: float) -> tuple[float, ...]:
    del friction, speed
    return ()


def _steepness(friction: Friction, ratio: float, effort: float) -> Steepness:
    """Return B·G² + |G|·Tc/v_s with the larger one of both directions."""
    del effort
    dry = max(friction.coulomb_positive, -friction.coulomb_negative)
    steep = abs(ratio) * dry / friction.smoothing_speed if dry else 0.0
    return Steepness(ratio**2 * friction.viscous + steep)


FRICTION = FrictionBlock(
    numbers=("viscous", "coulomb_positive", "coulomb_negative", "smoothing_speed"),
    states=(),
    trace=_trace,
    sliding=_sliding,
    steady=_steady,
    steepness=_steepness,
)
