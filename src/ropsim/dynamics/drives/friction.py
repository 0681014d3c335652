"""Friction of a drive as torque at the joint."""

from ropsim.codegen import Scalar, tanh
from ropsim.dynamics.drives.block import Numbers

FRICTION_NUMBERS = ("viscous", "coulomb_positive", "coulomb_negative", "smoothing_speed")
"""Attributes of `model.Friction` that the formula takes."""


def trace_friction(p: Numbers, ratio: Scalar, qd: Scalar) -> Scalar:
    """Return the torque that the drive spends on friction at joint speed `qd` [N·m | N].

    It is B·G²·q̇ + |G|·Tc·tanh(q̇/v_s), where Tc is the Coulomb torque of the direction of motion, taken as a
    magnitude; friction itself acts on the joint with the opposite sign. Near standstill tanh takes the place
    of the jump, so that the equations can be integrated with a fixed step. P. I. Corke, B.
    Armstrong-Hélouvry: A search for consensus among model parameters reported for the PUMA 560 robot, ICRA
    1994, have both directions.

    Args:
        p: numbers of the friction.
        ratio: G.
        qd: joint speed.
    """
    viscous, positive, negative, smoothing = p
    forward, backward, size = abs(positive), abs(negative), abs(ratio)
    shape = tanh(qd * (1.0 / smoothing))
    # mean·x + half·|x| is Tc+·x for x > 0 and Tc-·x for x < 0, without a branch
    mean, half = size * (0.5 * (forward + backward)), size * (0.5 * (forward - backward))
    return viscous * (ratio * ratio) * qd + (mean * shape + half * abs(shape))
