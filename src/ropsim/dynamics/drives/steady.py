"""A drive in a steady state: the command of its controller for an effort at the joint."""

from collections.abc import Sequence
from math import inf, isfinite
from typing import NamedTuple

from ropsim.dynamics.drives.ball_screw import threads_slope
from ropsim.dynamics.drives.block import Limit, Steepness
from ropsim.dynamics.drives.chain import chain_of
from ropsim.model import BallScrew, Drive, InputKind


class SteadyDrive(NamedTuple):
    """Steady state of a drive with a constant effort at a joint.

    Attributes:
        states: of motor, transmission, friction and hub.
        output: of the amplifier, in the sense of the motor.
        command: of the joint controller; positive drives the joint forward.
    """

    states: tuple[float, ...]
    output: float
    command: float


def steady_drive(drive: Drive, q: float, qd: float, effort: float) -> SteadyDrive:
    """Return the drive with an effort at constant speed; friction is a part of the effort.

    Args:
        drive: the drive.
        q: joint coordinate [rad | m].
        qd: joint speed [rad/s | m/s].
        effort: at the joint [N·m | N].
    """
    chain = chain_of(drive)
    q = chain.link.hub(drive.link, q, effort) if chain.link else q
    gear = chain.transmission.rest(drive.transmission, q, effort)
    speed = drive.ratio_at(q) * qd
    motor = chain.motor.steady(drive.motor, gear.needs, speed)
    rubbed = chain.friction.steady(drive.friction, speed)
    command = drive.sense * motor.needs
    hub = (q, qd) if chain.link else ()
    return SteadyDrive((*motor.states, *gear.states, *rubbed, *hub), motor.needs, command)


def reflected_inertia(drive: Drive, q: float) -> float:
    """Return J·G² [kg·m² | kg], the inertia of the rotor as the joint at q sees it through a rigid gear.

    That of the hub before an elastic link is in it.
    """
    ratio = drive.ratio_at(q)
    rotor = drive.turning_inertia * ratio * ratio
    return rotor + drive.link.hub_inertia if drive.link else rotor


def friction_steepness(drive: Drive, q: float) -> Steepness:
    """Return how steep the friction of a drive and its threads is at rest, as its joint at q sees it."""
    law, effort = chain_of(drive).friction, largest_effort(drive, q)
    found = law.steepness(drive.friction, drive.ratio_at(q), effort)
    if isinstance(drive.transmission, BallScrew) and isfinite(effort):
        return found._replace(slope=found.slope + threads_slope(drive.transmission, effort))
    return found


def command_limit(drive: Drive) -> float:
    """Return the largest magnitude that the amplifier of a drive puts out; inf where it is open."""
    return float(getattr(drive.amplifier, chain_of(drive).amplifier.numbers[0]))


class CommandBand(NamedTuple):
    """The commands that an amplifier which reads its motor passes unclipped, at one joint speed.

    They lie between per_speed·q̇ - span and per_speed·q̇ + span.

    Attributes:
        per_speed: [V·s/rad | V·s/m].
        span: [V]; inf if the amplifier does not read its motor.
    """

    per_speed: float
    span: float


def command_band(drive: Drive) -> CommandBand:
    """Return the commands that the amplifier of a drive passes unclipped, within its largest output.

    Of a DC motor with a current limit it is |G|·Ke·q̇ ± R·i_max.

    Args:
        drive: the drive.
    """
    chain = chain_of(drive)
    if chain.amplifier.within is None:
        return CommandBand(0.0, inf)
    names = {state.name for state in chain.motor.states}
    held = tuple(limit for limit in chain.amplifier.limits if limit.column in names)
    per_effort = steady_drive(drive, 0.0, 0.0, 1.0).command
    per_speed = steady_drive(drive, 0.0, 1.0, 0.0).command
    return CommandBand(per_speed, per_effort * _bound(drive, held))


def largest_effort(drive: Drive, q: float) -> float:
    """Return the largest torque or force that a drive can keep up at its joint at standstill [N·m | N].

    The states of its motor and the output of its amplifier are proportional to the effort; the first of them
    that comes to a limit of the drive sets the bound. Of a DC motor it is |G|·Kt times the smaller of the
    largest current and the one that the largest voltage drives through the resistance, of a hydraulic motor
    the force of its supply pressure.

    Args:
        drive: the drive; friction is no part of the effort.
        q: joint coordinate [rad | m].

    Returns:
        Infinite where the drive has no limit.
    """
    chain = chain_of(drive)
    if chain.motor.most is None:
        return _bound(drive, chain.amplifier.limits)
    most = chain.motor.most(drive.motor) * abs(drive.ratio_at(q))
    is_told = chain.motor.takes is InputKind.EFFORT
    return min(most, _bound(drive, chain.amplifier.limits)) if is_told else most


def _bound(drive: Drive, limits: Sequence[Limit]) -> float:
    """Return the effort at which the first of some limits of a drive is reached at standstill."""
    chain = chain_of(drive)
    unit, free = (steady_drive(drive, 0.0, 0.0, effort) for effort in (1.0, 0.0))
    columns = (*chain.states, chain.amplifier.output)
    pairs = zip((*unit.states, unit.output), (*free.states, free.output), strict=True)
    share = dict(zip((column.name for column in columns), (one - none for one, none in pairs), strict=True))
    bounds = (
        getattr(drive.amplifier, limit.number) / abs(share[limit.column])
        for limit in limits
        if share.get(limit.column)
    )
    return min(map(float, bounds), default=inf)
