"""Writer of SDFormat; losses are reported."""

from collections.abc import Iterable

from ropsim.core import Diagnostic
from ropsim.exchange.files.names import BASE, FLANGE, unused
from ropsim.exchange.files.xml_text import Tag, number, tag, value, xml_text
from ropsim.exchange.losses.loss_diagnostics import LOST_DRIVE
from ropsim.exchange.sdf.text import inertial, pose, visuals
from ropsim.exchange.writing.motion_losses import axis_losses, limit_losses
from ropsim.exchange.writing.write_losses import (
    drive_losses,
    friction_at_joint,
    look_losses,
    word_losses,
)
from ropsim.exchange.writing.written_tree import WrittenJoint, WrittenTree, written_tree
from ropsim.model import WITHOUT_END, JointType, RobotModel, WrittenRobot

VERSION = "1.11"
"""Of SDFormat: the first one in which a joint can follow another."""


def write_sdf(robot: RobotModel) -> WrittenRobot:
    """Return the SDFormat model of a robot that stands on the world, and its losses.

    Links are called after the joints that move them, `base_link` is fixed to the world, and the frame
    `flange` is the mechanical interface. A joint with several freedoms becomes several joints.

    Raises:
        MechanismError: the robot cannot be.
    """
    tree = written_tree(robot)
    names = {one.name for one in tree.joints}
    base = tag("link", [("name", BASE)], *visuals(robot.base_shapes))
    stand = _ends(unused("world_joint", names), "fixed", "world", BASE)
    parts = [base, stand]
    for one in tree.joints:
        at = pose(one.placement, tree.parent(one))
        looks = visuals(one.link.shapes if one.link else ())
        parts.append(tag("link", [("name", one.child)], *at, inertial(one.link), *looks))
        parts.append(_joint(robot, tree, one))
    carrier = BASE if tree.carrier < 0 else tree.joints[tree.carrier].child
    parts.append(tag("frame", [("name", FLANGE), ("attached_to", carrier)], *pose(robot.X_nM)))
    model = tag("model", [("name", robot.name)], *parts)
    return WrittenRobot(xml_text(tag("sdf", [("version", VERSION)], model)), tuple(_losses(robot, tree)))


def _ends(name: str, kind: str, parent: str, child: str, *parts: Tag) -> Tag:
    ends = (value("parent", parent), value("child", child))
    return tag("joint", [("name", name), ("type", kind)], *ends, *parts)


def _joint(robot: RobotModel, tree: WrittenTree, one: WrittenJoint) -> Tag:
    if one.type is JointType.FIXED:
        return _ends(one.name, "fixed", tree.parent(one), one.child)
    parts = [value("xyz", "0 0 1"), _limit(one), *_dynamics(robot, one), *_mimic(tree, one)]
    kind = "prismatic" if one.type is JointType.PRISMATIC else "revolute"
    return _ends(one.name, kind, tree.parent(one), one.child, tag("axis", (), *parts))


def _limit(one: WrittenJoint) -> Tag:
    joint = one.joint
    bounded = one.own and not joint.is_endless
    lower, upper = (joint.lower, joint.upper) if bounded else (-WITHOUT_END, WITHOUT_END)
    rows = [value("lower", number(lower)), value("upper", number(upper))]
    if joint.max_effort < float("inf"):
        rows.append(value("effort", number(joint.max_effort)))
    return tag("limit", (), *rows, value("velocity", number(joint.max_speed)))


def _dynamics(robot: RobotModel, one: WrittenJoint) -> tuple[Tag, ...]:
    if one.axis is None or not robot.drives:
        return ()
    viscous, dry = friction_at_joint(robot.drives[one.axis], float(robot.home[one.axis]))
    if not viscous and not dry:
        return ()
    return (tag("dynamics", (), value("damping", number(viscous)), value("friction", number(dry))),)


def _mimic(tree: WrittenTree, one: WrittenJoint) -> tuple[Tag, ...]:
    if one.follows is None:
        return ()
    axis, factor = one.follows
    rows = (("multiplier", factor), ("offset", one.constant), ("reference", 0.0))
    entries = [value(name, number(figure)) for name, figure in rows]
    return (tag("mimic", [("joint", tree.joints[tree.drivers[axis]].name)], *entries),)


def _losses(robot: RobotModel, tree: WrittenTree) -> Iterable[Diagnostic]:
    yield from limit_losses(robot, tree)
    yield from axis_losses(robot)
    words = f"greatest accelerations and jerks of the axes of `{robot.name}` do not go over"
    yield LOST_DRIVE.at(None, words, hint="give them to the controller on the other side")
    yield from drive_losses(robot)
    yield from look_losses(robot)
    yield from word_losses(robot)
