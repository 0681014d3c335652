"""Friction of a drive as torque at the joint."""

from ropsim.codegen import Scalar, tanh
from ropsim.model import Drive


def trace_friction(drive: Drive, qd: Scalar) -> Scalar:
    """Return the torque that the drive spends on friction at joint speed `qd` [N·m | N].

    It is B·G²·q̇ + |G|·Tc·tanh(q̇/v_s), where Tc is the Coulomb torque of the direction of motion, taken as a
    magnitude; friction itself acts on the joint with the opposite sign. Near standstill tanh takes the place
    of the jump, so that the equations can be integrated with a fixed step. P. I. Corke,
    B. Armstrong-Hélouvry: A search for consensus among model parameters reported for the PUMA 560 robot,
    ICRA 1994, give both directions.
    """
    friction, ratio = drive.friction, abs(drive.ratio)
    forward, backward = abs(friction.coulomb_positive), abs(friction.coulomb_negative)
    shape = tanh(qd * (1.0 / friction.smoothing_speed))
    # mean·x + half·|x| is Tc+·x for x > 0 and Tc-·x for x < 0, without a branch
    mean, half = 0.5 * (forward + backward), 0.5 * (forward - backward)
    coulomb = ratio * mean * shape + ratio * half * abs(shape)
    return friction.viscous * drive.ratio * drive.ratio * qd + coulomb
