"""Losses of the axes of a robot in a file: their order, their limits, gravity, closed chains."""

from collections.abc import Iterable

from ropsim.core import Diagnostic
from ropsim.exchange.losses.gathered import listed
from ropsim.exchange.losses.loss_diagnostics import LOST_DRIVE, LOST_MOTION
from ropsim.exchange.writing.written_tree import WrittenTree
from ropsim.model import HydraulicCylinder, JointType, RobotModel

_GRAVITY = [0.0, 0.0, -9.81]
_DOWN_HINT = "turn the base frame so that its z axis points up"


def limit_losses(robot: RobotModel, tree: WrittenTree) -> Iterable[Diagnostic]:
    """Yield the joints whose limits go into no format: they are written as several joints."""
    held = {one.joint.name for one in tree.joints if one.own or one.type is JointType.FIXED}
    names = [joint.name for joint in robot.joints if joint.type.freedoms and joint.name not in held]
    if names:
        words = f"joints {listed(names)} are written as several joints each, without their limits"
        yield LOST_MOTION.at(None, words, data={"joints": tuple(names)})


def spring_losses(robot: RobotModel) -> Iterable[Diagnostic]:
    """Yield the springs and dampers that go into no other format than NIROX and the robot file."""
    names = [one.name for one in robot.springs] + [one.name for one in robot.joint_springs]
    if names:
        words = f"springs and dampers {listed(names)} of `{robot.name}` do not go over"
        yield LOST_MOTION.at(None, words, hint="NIROX holds them", data={"springs": tuple(names)})


def axis_losses(robot: RobotModel) -> Iterable[Diagnostic]:
    """Yield the losses of formats in which axes have the order of the file and gravity points down."""
    if list(robot.axes) != sorted(robot.axes):
        words = f"the axes of `{robot.name}` are counted in another order, that of its joints"
        yield LOST_MOTION.at(None, words, hint="name the axes by their joints on the other side")
    if robot.cuts:
        words = f"{len(robot.cuts)} closed chains of `{robot.name}` do not go over"
        yield LOST_MOTION.at(None, words, hint="MJCF holds them")
    yield from spring_losses(robot)
    if robot.gravity.tolist() != _GRAVITY:
        words = f"gravity of `{robot.name}` does not point down along z of its base frame"
        yield LOST_MOTION.at(None, words, hint=_DOWN_HINT)
    pairs = list(zip(robot.axis_joints, robot.drives, strict=False))
    rods = [joint.name for joint, drive in pairs if isinstance(drive.motor, HydraulicCylinder)]
    rotors = [joint.name for joint, drive in pairs if drive.motor.rotor_inertia and joint.name not in rods]
    for names, what in ((rotors, "inertias of the rotors"), (rods, "masses of the rods")):
        if names:
            words = f"{what} of axes {listed(names)} do not go over"
            yield LOST_DRIVE.at(None, words, hint="MJCF holds them", data={"axes": tuple(names)})
