"""A robot file to a robot (manual: docs/reference/robot-file.md)."""

from dataclasses import replace
from math import inf
from pathlib import PurePath

import numpy as np

from ropsim.core import SourceText
from ropsim.kinematics import loop_freedom
from ropsim.model import (
    BASE_LINK,
    ArmClass,
    Joint,
    JointType,
    PublishedPathLimits,
    ReadRobot,
    RobotModel,
    Shape,
    audit,
    number_findings,
    with_coupled_axes,
)
from ropsim.robotfile import diagnostics as kinds
from ropsim.robotfile.dh_table import DhTable, read_dh_table
from ropsim.robotfile.drives import read_drives
from ropsim.robotfile.estimation.recognition import class_of_joints
from ropsim.robotfile.frames.bodies import read_frame_links
from ropsim.robotfile.frames.loops import read_joint_springs, read_loops, read_springs
from ropsim.robotfile.frames.rows import link_named, read_frame_rows
from ropsim.robotfile.frames.words import BASE
from ropsim.robotfile.links import Links, read_links
from ropsim.robotfile.origins import estimates, read_origins
from ropsim.robotfile.places import robot_file_places
from ropsim.robotfile.reach import check_reach
from ropsim.spatial import Array, Pose, frozen
from ropsim.tomltext import (
    Look,
    Quantity,
    TomlTable,
    Units,
    read_document,
    read_look,
    read_pose,
    read_shapes,
    read_units,
)

FRAMES = "frames"
CONVENTIONS = ("standard", "modified", FRAMES)
CLASSES = tuple(one.value for one in ArmClass if one is not ArmClass.PALLETIZER)
"""Classes of arms that a robot file describes."""
ALL_CLASSES = tuple(one.value for one in ArmClass)
PAYLOAD = Quantity("kg", 1.0, 1e-3, 1e5)
GRAVITY = Quantity("m/s²", 1.0, -100.0, 100.0)
DOWN = (0.0, 0.0, -9.81)
"""Gravity of an arm whose file says nothing of it [m/s²]."""
_ROUNDED = 1e-9  # [rad | m] of a rest position on a limit


def read_robot_file(source: SourceText) -> ReadRobot:
    """Return the robot that a robot file describes, everything in SI units.

    Args:
        source: content of the file; any text is allowed.
    """
    root, syntax = read_document(source)
    if root is None:
        return ReadRobot(None, syntax)
    robot = _robot(root, source)
    found = root.findings.ordered()
    if robot is None or any(one.is_error for one in found):
        return ReadRobot(None, found)
    wrong = tuple(one for one in audit(robot, robot_file_places(source)) if one.is_error)
    if robot.cuts and not wrong:
        at = root.key_span("loops")
        wrong = tuple(replace(one, span=at) for one in loop_freedom(robot))
    return ReadRobot(None if wrong else robot, (*found, *wrong))


def _robot(root: TomlTable, source: SourceText) -> RobotModel | None:
    units = read_units(root.table("units"))
    stem = PurePath(source.name).stem
    name = root.text("name", stem) or stem
    title = root.text("title", name)
    root.require("convention", "joints")
    convention = root.choice("convention", CONVENTIONS, CONVENTIONS[0]) if "convention" in root else ""
    if convention == FRAMES:
        return _of_frames(root, source, units, (name, title))
    X_B0, base_shapes = _base(root.table("base"), units)
    table = read_dh_table(root, convention or CONVENTIONS[0], units, X_B0)
    X_NM = _flange(root.table("flange"), units)
    origins = read_origins(root, PurePath(source.name).name)
    if table is None:
        _pass_over(root)
        return None
    X_nM = table.interface @ X_NM
    arm_class = ArmClass(root.choice("class", CLASSES, CLASSES[0])) if "class" in root else None
    links = read_links(root, table, X_nM, arm_class or class_of_joints(table.joints), units)
    drives = read_drives(root, table)
    if drives and not links.has_mass:
        message = "there are `drives`, and no link has a mass"
        hint = "give `links` with masses, or `mass`, that of all moving links"
        root.findings.add(kinds.DRIVES_WITHOUT_MASSES, root.key_span("drives"), message, hint)
    home = _home(root, table.joints, units)
    rated_payload = root.number("payload", PAYLOAD, inf) if "payload" in root else inf
    path_limits = _path_limits(root, units)
    gravity = frozen(root.numbers("gravity", 3, GRAVITY, DOWN))
    wrong = tuple(
        number_findings(
            table.joints, links.links, range(len(table.joints)), drives, robot_file_places(source)
        )
    )
    if wrong:
        root.findings.items.extend(wrong)
        root.finish()
        return None
    places = {BASE: BASE_LINK} | {joint.name: number for number, joint in enumerate(table.joints)}
    frames = [table.frame(number) for number in range(len(table.joints))]
    robot = RobotModel(
        name=name,
        title=title,
        joints=table.joints,
        links=links.links,
        drives=drives,
        home=home,
        springs=read_springs(root, places, frames, units),
        joint_springs=read_joint_springs(root, table.joints, units),
        gravity=gravity,
        origins=(*origins, *estimates(table, links)),
        base_shapes=base_shapes,
        X_nM=X_nM,
        dh=table.rows if convention == "standard" else (),
        rated_payload=rated_payload,
        arm_class=arm_class,
        path_limits=path_limits,
    )
    if table.coupled and not any(one.is_error for one in root.findings.items):
        robot = with_coupled_axes(robot, table.coupled)
    check_reach(root, robot, units)
    root.finish()
    return robot


def _of_frames(
    root: TomlTable, source: SourceText, units: Units, names: tuple[str, str]
) -> RobotModel | None:
    """Return the robot of a file whose joints stand by their frames."""
    base = root.table("base")
    base_shapes = read_shapes(base, units, read_look(base, Look()))
    base.finish()
    origins = read_origins(root, PurePath(source.name).name)
    rows = read_frame_rows(root, units)
    if rows is None:
        _pass_over(root)
        return None
    flange, joints = root.table("flange"), rows.joints
    tip, X_nM = link_named(flange, "on", rows.places, len(joints) - 1), read_pose(flange, units)
    flange.finish()
    links = read_frame_links(root, len(joints), units)
    driven = tuple(joints[number] for number in rows.axes)
    table = DhTable("modified", (), Pose(), driven, (), rows.estimated)
    drives = read_drives(root, table)
    home = _home(root, driven, units)
    arm_class = ArmClass(root.choice("class", ALL_CLASSES, CLASSES[0])) if "class" in root else None
    rated_payload = root.number("payload", PAYLOAD, inf) if "payload" in root else inf
    path_limits = _path_limits(root, units)
    gravity = frozen(root.numbers("gravity", 3, GRAVITY, DOWN))
    frames = [Pose() for _ in joints]
    cuts = read_loops(root, rows.places, units)
    springs = read_springs(root, rows.places, frames, units)
    on_joints = read_joint_springs(root, joints, units)
    wrong = tuple(number_findings(joints, links, rows.axes, drives, robot_file_places(source)))
    root.findings.items.extend(wrong)
    root.finish()
    if wrong or not rows.axes or any(one.is_error for one in root.findings.items):
        return None
    return RobotModel(
        name=names[0],
        title=names[1],
        joints=joints,
        links=links,
        drives=drives,
        home=home,
        axes=rows.axes,
        couplings=rows.couplings,
        cuts=cuts,
        springs=springs,
        joint_springs=on_joints,
        gravity=gravity,
        origins=(*origins, *estimates(table, Links(links, ()))),
        base_shapes=base_shapes,
        X_nM=X_nM,
        tip=tip,
        rated_payload=rated_payload,
        arm_class=arm_class,
        path_limits=path_limits,
    )


def _base(table: TomlTable, units: Units) -> tuple[Pose, tuple[Shape, ...]]:
    """Return frame 0 of the table in the base frame, and the shapes of the foot, in the base frame."""
    X_B0, shapes = read_pose(table, units), read_shapes(table, units, read_look(table, Look()))
    table.finish()
    return X_B0, shapes


def _flange(table: TomlTable, units: Units) -> Pose:
    """Return the mechanical interface in the last frame of the table."""
    X_NM = read_pose(table, units)
    table.finish()
    return X_NM


def _home(root: TomlTable, joints: tuple[Joint, ...], units: Units) -> Array:
    """Return the rest position: that of the file, else all zero, or the middle of a range without zero."""
    default = [0.0 if one.lower <= 0.0 <= one.upper else 0.5 * (one.lower + one.upper) for one in joints]
    value = root.values.get("home", default) if "home" in root else default
    if not isinstance(value, list):
        root.wrong_type(("home",), value, "a list of numbers")
        return np.array(default)
    if value is default:
        return frozen(default)
    if len(value) != len(joints):
        root.wrong_count(("home",), value, f"{len(joints)}, one per joint")
        return np.array(default)
    given = [
        root.number_at(("home", k), item, _coordinate(joint, units), default[k])
        for k, (item, joint) in enumerate(zip(value, joints, strict=True))
    ]
    return frozen(np.clip(given, [one.lower for one in joints], [one.upper for one in joints]))


def _path_limits(root: TomlTable, units: Units) -> PublishedPathLimits | None:
    """Return the limits of tool paths that the maker publishes; None where the file says nothing of them."""
    asked = {
        name: quantity
        for name, quantity in (
            ("path_acceleration", units.path(2, 1e3)),
            ("path_jerk", units.path(3, 1e5)),
            ("orientation_speed", units.orientation(1, 100.0)),
            ("orientation_acceleration", units.orientation(2, 1e4)),
            ("orientation_jerk", units.orientation(3, 1e6)),
        )
        if name in root
    }
    given = {name.removeprefix("path_"): root.number(name, one, 1.0) for name, one in asked.items()}
    return PublishedPathLimits(**given) if given else None


def _coordinate(joint: Joint, units: Units) -> Quantity:
    """Return the quantity of a joint coordinate; it lies within the limits, except for rounding."""
    way = units.turn if joint.type is JointType.REVOLUTE else units.position
    return way.within(joint.lower - _ROUNDED, joint.upper + _ROUNDED)


def _pass_over(root: TomlTable) -> None:
    """Mark keys that have no meaning without joints as read."""
    for key in root.values:
        root.asked[key] = None
