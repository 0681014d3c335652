"""Writer of a robot as a plain mechanism of AP242 (ISO 10303-242); losses are reported."""

from collections.abc import Iterable
from math import isfinite

from ropsim.core import Diagnostic, Kind
from ropsim.exchange.files.names import BASE, link_name
from ropsim.exchange.losses.gathered import listed
from ropsim.exchange.losses.loss_diagnostics import LOST_DESCRIPTION, LOST_DRIVE, LOST_MASS, LOST_MOTION
from ropsim.exchange.writing.motion_losses import spring_losses
from ropsim.exchange.writing.write_losses import drive_losses, word_losses
from ropsim.model import FrictionLaw, RobotModel, WrittenRobot

_GRAVITY = [0.0, 0.0, -9.81]


def write_ap242(robot: RobotModel) -> WrittenRobot:
    """Return the mechanism of a robot as a file of AP242, without data that only NIROX has, and the losses.

    Raises:
        MechanismError: the robot cannot be.
    """
    from ropsim.nirox import write_mechanism

    written = write_mechanism(robot)
    if not written.text:
        return written
    return WrittenRobot(written.text, (*written.losses, *_losses(robot)))


def _losses(robot: RobotModel) -> Iterable[Diagnostic]:
    yield from _motion_losses(robot)
    heavy = [
        joint.name
        for joint, link in zip(robot.joints, robot.links, strict=True)
        if link.mass or link.inertia.any()
    ]
    yield from _named(LOST_MASS, "masses, centres of mass and inertias of the links of joints", heavy)
    yield from _axis_losses(robot)
    yield from drive_losses(robot)
    looks = [(BASE, robot.base_shapes)]
    looks += [(link_name(one.name), link.shapes) for one, link in zip(robot.joints, robot.links, strict=True)]
    drawn = [name for name, shapes in looks if shapes]
    yield from _named(LOST_DESCRIPTION, "the shapes of", drawn, hint="CAD systems have shapes of their own")
    yield from word_losses(robot, home="")


def _motion_losses(robot: RobotModel) -> Iterable[Diagnostic]:
    """Yield the losses that change the motion."""
    followers = _coupled(robot)
    for name, words in followers.items():
        sentence = f"joint `{name}` is an axis of its own on the other side; here {words}"
        yield LOST_MOTION.at(None, sentence, hint="couple it there", data={"joints": (name,)})
    several = [joint.name for joint in robot.joints if joint.type.freedoms > 1]
    if several:
        sentence = f"coordinates of joints {listed(several)} are free on the other side, and held by nothing"
        yield LOST_MOTION.at(
            None, sentence, hint="NIROX says what they follow", data={"joints": tuple(several)}
        )
    if robot.cuts:
        sentence = (
            f"which joints of the closed chains of `{robot.name}` are driven does not go over, the loops do"
        )
        yield LOST_MOTION.at(None, sentence, hint="NIROX says where they are cut")
    yield from spring_losses(robot)
    if robot.gravity.tolist() != _GRAVITY:
        sentence = (
            f"gravity of `{robot.name}` does not point down along z of its base frame, and does not go over"
        )
        yield LOST_MOTION.at(None, sentence, hint="say on the other side how it is mounted")


def _coupled(robot: RobotModel) -> dict[str, str]:
    """Return how each joint follows others, by its name."""
    names = [joint.name for joint in robot.joints for _ in range(joint.type.freedoms)]
    found = {}
    for coupling in robot.couplings:
        terms = [f"{factor:+g}·{names[other]}" for other, factor in coupling.terms]
        if coupling.constant:
            terms.append(f"{coupling.constant:+g}")
        found[names[coupling.dependent]] = f"it follows others: {' '.join(terms) or '0'}"
    return found


def _axis_losses(robot: RobotModel) -> Iterable[Diagnostic]:
    """Yield the losses of data of axes other than their ranges."""
    joints, drives = robot.axis_joints, robot.drives
    hint = "give them to the controller on the other side"
    limits = f"greatest speeds, accelerations and jerks of axes {listed(one.name for one in joints)}"
    yield LOST_DRIVE.at(None, f"{limits} do not go over", hint=hint)
    efforts = [one.name for one in joints if isfinite(one.max_effort)]
    yield from _named(LOST_DRIVE, "greatest efforts of axes", efforts)
    pairs = tuple(zip(joints, drives, strict=False))
    rubbing = [joint.name for joint, drive in pairs if _rubs(drive.friction)]
    yield from _named(LOST_DRIVE, "friction of axes", rubbing)
    turning = [joint.name for joint, drive in pairs if drive.motor.rotor_inertia]
    yield from _named(LOST_DRIVE, "inertias of the rotors of axes", turning)


def _rubs(friction: FrictionLaw) -> bool:
    return any((friction.viscous, friction.coulomb_positive, friction.coulomb_negative))


def _named(kind: Kind, what: str, names: list[str], hint: str = "") -> Iterable[Diagnostic]:
    if names:
        yield kind.at(None, f"{what} {listed(names)} do not go over", hint=hint, data={"names": tuple(names)})
