"""Drives of a robot whose file has joints only: sources of torque with friction and rotors."""

from collections.abc import Sequence
from dataclasses import replace

from ropsim.exchange.assembly.description import Connection
from ropsim.model import BASE_LINK, Drive, Friction, IdealMotor, Joint, Link, ideal_drive


def drives_of(
    driven: Sequence[Connection], axes: Sequence[int], joints: Sequence[Joint], links: Sequence[Link]
) -> tuple[Drive, ...]:
    """Return a drive for each axis; none at all where some axis moves nothing that has a weight.

    Args:
        driven: connections that are driven.
        axes: number of the joint of each, in the same order.
        joints: of the robot.
        links: moved by the joints.
    """
    weighs = [bool(link.mass or link.inertia.any()) for link in links]
    for number in reversed(range(len(joints))):
        if weighs[number] and joints[number].parent != BASE_LINK:
            weighs[joints[number].parent] = True
    if not all(weighs[number] for number in axes):
        return ()
    return tuple(_drive(one, joints[number].max_effort) for one, number in zip(driven, axes, strict=True))


def _drive(one: Connection, effort: float) -> Drive:
    viscous, dry = one.resistance.viscous, one.resistance.dry
    return replace(
        ideal_drive(effort),
        motor=IdealMotor(one.resistance.rotor),
        friction=Friction(viscous, dry, -dry if dry else 0.0),
    )
