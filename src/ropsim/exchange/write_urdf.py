"""A robot becomes URDF, and what URDF cannot say is told."""

from collections.abc import Iterable
from dataclasses import replace

from ropsim.core import Diagnostic
from ropsim.exchange.joint_limits import WITHOUT_END
from ropsim.exchange.loss_diagnostics import LOST_DRIVE, LOST_MOTION
from ropsim.exchange.names import BASE, FLANGE, unused
from ropsim.exchange.notes import listed
from ropsim.exchange.urdf.text import endless, inertial, limit, origin, visuals
from ropsim.exchange.write_losses import (
    drive_losses,
    friction_at_joint,
    limit_losses,
    look_losses,
    rotor_at_joint,
    word_losses,
)
from ropsim.exchange.written_tree import WrittenJoint, WrittenTree, written_tree
from ropsim.exchange.xml_text import Tag, number, tag, xml_text
from ropsim.model import JointType, Link, RobotModel, WrittenRobot

_GRAVITY = [0.0, 0.0, -9.81]
_DOWN_HINT = "turn the base frame so that its z axis points up"


def write_urdf(robot: RobotModel) -> WrittenRobot:
    """Return the URDF of a robot, and what of it that does not hold.

    Links are called after the joints that move them, `base_link` stands still, and `flange` is the mechanical
    interface. A joint with several freedoms becomes several joints. The same robot has the same text.

    Raises:
        MechanismError: the robot cannot be.
    """
    tree = written_tree(robot)
    links = [_link(BASE, None, visuals(robot.base_shapes))]
    joints = []
    for one in tree.joints:
        links.append(_link(one.child, one.link, visuals(one.link.shapes if one.link else ())))
        joints.append(_joint(robot, tree, one))
    carrier = BASE if tree.carrier < 0 else tree.joints[tree.carrier].child
    end = unused(f"{FLANGE}_joint", {one.name for one in tree.joints})
    links.append(tag("link", [("name", FLANGE)]))
    joints.append(_fixed(end, carrier, FLANGE, origin(robot.X_nM)))
    root = tag("robot", [("name", robot.name)], *links, *joints)
    return WrittenRobot(xml_text(root), tuple(_losses(robot, tree)))


def _link(name: str, link: Link | None, looks: tuple[Tag, ...]) -> Tag:
    return tag("link", [("name", name)], *(inertial(link) if link else ()), *looks)


def _fixed(name: str, parent: str, child: str, at: tuple[Tag, ...]) -> Tag:
    ends = (tag("parent", [("link", parent)]), tag("child", [("link", child)]))
    return tag("joint", [("name", name), ("type", "fixed")], *at, *ends)


def _joint(robot: RobotModel, tree: WrittenTree, one: WrittenJoint) -> Tag:
    if one.type is JointType.FIXED:
        return _fixed(one.name, tree.parent(one), one.child, origin(one.placement))
    joint = one.joint if one.own else replace(one.joint, lower=-WITHOUT_END, upper=WITHOUT_END)
    turns = "continuous" if endless(joint) else "revolute"
    kind = "prismatic" if one.type is JointType.PRISMATIC else turns
    parts = [
        *origin(one.placement),
        tag("parent", [("link", tree.parent(one))]),
        tag("child", [("link", one.child)]),
        tag("axis", [("xyz", "0 0 1")]),
        limit(joint),
        *_dynamics(robot, one),
        *_mimic(tree, one),
    ]
    return tag("joint", [("name", one.name), ("type", kind)], *parts)


def _dynamics(robot: RobotModel, one: WrittenJoint) -> tuple[Tag, ...]:
    if one.axis is None or not robot.drives:
        return ()
    viscous, dry = friction_at_joint(robot.drives[one.axis])
    if not viscous and not dry:
        return ()
    return (tag("dynamics", [("damping", number(viscous)), ("friction", number(dry))]),)


def _mimic(tree: WrittenTree, one: WrittenJoint) -> tuple[Tag, ...]:
    if one.follows is None:
        return ()
    axis, factor = one.follows
    followed = tree.joints[tree.drivers[axis]].name
    entries = [("joint", followed), ("multiplier", number(factor)), ("offset", number(one.constant))]
    return (tag("mimic", entries),)


def _losses(robot: RobotModel, tree: WrittenTree) -> Iterable[Diagnostic]:
    yield from limit_losses(robot, tree)
    if list(robot.axes) != sorted(robot.axes):
        words = f"the axes of `{robot.name}` are counted in another order, that of its joints"
        yield LOST_MOTION.at(None, words, hint="name the axes by their joints on the other side")
    if robot.cuts:
        words = f"{len(robot.cuts)} closed chains of `{robot.name}` do not go over, URDF has none"
        yield LOST_MOTION.at(None, words, hint="MJCF and SDF hold them")
    if robot.gravity.tolist() != _GRAVITY:
        words = f"gravity of `{robot.name}` does not point down along z of its base frame"
        yield LOST_MOTION.at(None, words, hint=_DOWN_HINT)
    rotors = [
        joint.name
        for joint, drive in zip(robot.axis_joints, robot.drives, strict=False)
        if rotor_at_joint(drive)
    ]
    if rotors:
        words = f"inertias of the rotors of axes {listed(rotors)} do not go over"
        yield LOST_DRIVE.at(None, words, hint="MJCF holds them", data={"axes": tuple(rotors)})
    yield from drive_losses(robot)
    yield from look_losses(robot)
    yield from word_losses(robot)
