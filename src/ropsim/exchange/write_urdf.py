"""Writer of URDF; losses are reported."""

from collections.abc import Iterable
from dataclasses import replace

from ropsim.core import Diagnostic
from ropsim.exchange.files.names import BASE, FLANGE, unused
from ropsim.exchange.files.xml_text import Tag, number, tag, xml_text
from ropsim.exchange.urdf.text import inertial, limit, origin, visuals
from ropsim.exchange.writing.motion_losses import axis_losses, limit_losses
from ropsim.exchange.writing.write_losses import (
    drive_losses,
    friction_at_joint,
    look_losses,
    word_losses,
)
from ropsim.exchange.writing.written_tree import WrittenJoint, WrittenTree, written_tree
from ropsim.model import WITHOUT_END, JointType, Link, RobotModel, WrittenRobot


def write_urdf(robot: RobotModel) -> WrittenRobot:
    """Return the URDF of a robot, and its losses.

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
    turns = "continuous" if joint.is_endless else "revolute"
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
    viscous, dry = friction_at_joint(robot.drives[one.axis], float(robot.home[one.axis]))
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
    yield from axis_losses(robot)
    yield from drive_losses(robot)
    yield from look_losses(robot)
    yield from word_losses(robot)
