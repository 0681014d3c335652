"""A drive in a steady state: what its controller has to command for an effort at the joint."""

from math import copysign
from typing import NamedTuple

from ropsim.dynamics.drives.chain import chain_of
from ropsim.model import Drive


class SteadyDrive(NamedTuple):
    """What goes on giving an effort at a joint.

    Attributes:
        states: of motor and transmission.
        output: of the amplifier, in the sense of the motor.
        command: of the joint controller; positive drives the joint forward.
    """

    states: tuple[float, ...]
    output: float
    command: float


def steady_drive(drive: Drive, q: float, qd: float, effort: float) -> SteadyDrive:
    """Return the drive as it gives an effort at constant speed; friction is a part of the effort.

    Args:
        drive: the drive.
        q: joint coordinate [rad | m].
        qd: joint speed [rad/s | m/s].
        effort: at the joint [N·m | N].
    """
    chain = chain_of(drive)
    gear = chain.transmission.rest(drive.transmission, q, effort)
    motor = chain.motor.steady(drive.motor, gear.needs, drive.ratio * qd)
    command = copysign(1.0, drive.ratio) * motor.needs
    return SteadyDrive((*motor.states, *gear.states), motor.needs, command)


def reflected_inertia(drive: Drive) -> float:
    """Return J·G² [kg·m² | kg], the inertia of the rotor as the joint sees it through a rigid gear."""
    return drive.motor.rotor_inertia * drive.ratio * drive.ratio


def command_limit(drive: Drive) -> float:
    """Return the largest magnitude that the amplifier of a drive puts out; inf where it is open."""
    (name,) = chain_of(drive).amplifier.numbers
    return float(getattr(drive.amplifier, name))
