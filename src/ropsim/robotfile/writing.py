"""A robot to a robot file: its DH table, or one that is made from its axes."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import isfinite

import numpy as np

from ropsim.core import Diagnostic, SourceText, frozen_dataclass
from ropsim.model import (
    CoupledAxis,
    DhRow,
    Joint,
    JointType,
    Link,
    PublishedPathLimits,
    RobotModel,
    WrittenRobot,
    carrier_frame,
    fixed_part,
    snapped,
    without_coupled_axes,
)
from ropsim.robotfile.common_normals import common_normals
from ropsim.robotfile.diagnostics import NOT_IN_ROBOT_FILE
from ropsim.robotfile.drawn_bodies import without_drawn_bodies
from ropsim.robotfile.drive_words import PinFrames, drive_keys
from ropsim.robotfile.frames.writing import (
    frame_keys,
    joint_rows,
    sections,
    spring_sections,
    unwritten_couplings,
)
from ropsim.robotfile.hydraulics.supplies import supply_sections
from ropsim.robotfile.reading import DOWN, read_robot_file
from ropsim.robotfile.shape_words import shapes_text
from ropsim.robotfile.toml_words import (
    coordinate,
    inline,
    length,
    lines,
    number,
    pose_keys,
    range_text,
    rate,
    row,
    text,
    unless,
)
from ropsim.spatial import Pose

_ANYWHERE = PinFrames(Pose(), Pose())


@frozen_dataclass
class _Table:
    """A DH table and where things stand in it: frame 0, own frames of the joints in frames of the table."""

    convention: str
    rows: tuple[DhRow, ...]
    X_B0: Pose
    frames: tuple[Pose, ...]


def write_robot_file(robot: RobotModel) -> WrittenRobot:
    """Return the robot file of a robot.

    A serial arm of turning and sliding joints keeps the table that it was made from, or gets one of the
    modified form along the common normals of its axes. Any other mechanism is written by the frames of its
    joints. Read again it has the same kinematics, masses and drives.

    Args:
        robot: to be written; if a file cannot represent it, the text is empty and the losses name why, such
            as numbers that `read_robot_file` refuses.
    """
    undrawn = without_drawn_bodies(robot)
    serial, coupled = without_coupled_axes(undrawn.robot)
    if any(True for _ in _branching(serial)):
        return _of_frames(robot)
    robot = serial
    table, losses = _table(robot), tuple(_losses(robot, undrawn.names))
    X_NM = table.frames[-1] @ robot.X_nM
    head = {
        **_names(robot),
        "convention": text(table.convention),
        "home": row(coordinate(q, joint.type) for q, joint in zip(robot.home, robot.joints, strict=True)),
        **_figures(robot),
        "joints": _rows(
            [
                _joint(one, j) | _coupled(robot, coupled, k)
                for k, (one, j) in enumerate(zip(table.rows, robot.joints, strict=True))
            ]
        ),
    }
    parts = [lines(head)]
    for section, keys in (
        ("base", pose_keys(table.X_B0) | {"shapes": shapes_text(robot.base_shapes)}),
        ("flange", pose_keys(X_NM)),
    ):
        parts += [f"[{section}]\n{lines(keys)}"] if any(keys.values()) else []
    links = [_body(link, X) | _looks(link, X) for link, X in zip(robot.links, table.frames, strict=True)]
    if not any(link.mass > 0.0 or link.inertia.any() for link in robot.links):
        links = [_looks(link, X) for link, X in zip(robot.links, table.frames, strict=True)]
    parts += [f"[[links]]\n{lines(keys)}" for keys in links if any(any(one.values()) for one in links)]
    drives = [
        drive_keys(drive, frames)
        for drive, frames in zip(robot.drives, _pin_frames(robot, table), strict=False)
    ]
    parts += [f"[[drives]]\n{lines(keys)}" for keys in drives if keys and None not in drives]
    parts += [f"{heading}\n{lines(keys)}" for heading, keys in supply_sections(robot.drives)]
    parts += [f"{heading}\n{lines(keys)}" for heading, keys in spring_sections(robot, table.frames)]
    return _sure(robot, "\n".join(parts), losses)


def _of_frames(robot: RobotModel) -> WrittenRobot:
    """Return the robot file of a mechanism that is no chain: the frames of its joints, and its loops."""
    if unwritten_couplings(robot):
        message = f"`{robot.name}` has couplings of joints with several freedoms"
        hint = "a NIROX file holds all of it: let its name end in .stp"
        return WrittenRobot("", (NOT_IN_ROBOT_FILE.at(None, message, hint=hint),))
    head = {
        **_names(robot),
        **frame_keys(robot),
        **_figures(robot),
        "joints": _rows(joint_rows(robot)),
    }
    all_links = any(link.shapes or link.mass or link.inertia.any() or link.com.any() for link in robot.links)
    parts = [lines(head)]
    supplies = supply_sections(robot.drives)
    for heading, keys in (
        *sections(robot),
        *supplies,
        *spring_sections(robot, [Pose() for _ in robot.joints]),
    ):
        if any(keys.values()) or (heading == "[[links]]" and all_links):
            parts.append(f"{heading}\n{lines(keys)}")
    return _sure(robot, "\n".join(parts), tuple(_losses(robot, ())))


def _names(robot: RobotModel) -> dict[str, str]:
    return {"name": text(robot.name), "title": text(robot.title)}


def _figures(robot: RobotModel) -> dict[str, str]:
    """Return the keys of the file on the robot as a whole."""
    return {
        "gravity": "" if tuple(robot.gravity) == DOWN else row(map(number, robot.gravity.tolist())),
        "origins": _rows([_origin(one.parameters, one.kind, one.source) for one in robot.origins]),
        "class": text(robot.arm_class.value) if robot.arm_class is not None else "",
        "payload": number(robot.rated_payload) if isfinite(robot.rated_payload) else "",
        **_path_limits(robot.path_limits),
    }


def _sure(robot: RobotModel, written: str, losses: tuple[Diagnostic, ...]) -> WrittenRobot:
    """Return a text with its losses; none where it could not be read again."""
    unreadable = tuple(_unreadable(robot, written))
    return WrittenRobot("", unreadable) if unreadable else WrittenRobot(written, losses)


def _unreadable(robot: RobotModel, written: str) -> Iterator[Diagnostic]:
    """Yield why a written text could not be read again, with the joint in whose row it would be wrong."""
    names = [joint.name for joint in robot.joints]
    for one in read_robot_file(SourceText("robots/robot.toml", written)).findings:
        if one.is_error:
            joint = _joint_at(written.splitlines(), one.span.line, names) if one.span else ""
            where = f", at joint `{joint}`" if joint else ""
            message = f"a robot file cannot hold `{robot.name}`{where}: {one.message}"
            hint = "a NIROX file has other bounds: let its name end in .stp"
            yield NOT_IN_ROBOT_FILE.at(None, message, hint=hint)


def _joint_at(written: Sequence[str], line: int, names: Sequence[str]) -> str:
    """Return the name of the joint that a line of a written text is about; empty for a heading."""
    above = [] if written[line - 1].startswith("[") else written[:line]
    row = next((above.count(head) for head in ("[[drives]]", "[[links]]") if head in above), 0)
    if not row and "joints = [" in above:
        row = len(above) - above.index("joints = [") - 1
    return names[row - 1] if 0 < row <= len(names) else ""


def _table(robot: RobotModel) -> _Table:
    if robot.dh:
        fixed = tuple(Pose.from_matrix(fixed_part(one)).inverse() for one in robot.dh)
        return _Table("standard", robot.dh, robot.joints[0].placement, fixed)
    made = common_normals(robot.joints)
    return _Table("modified", made.rows, made.X_B0, made.frames)


def _pin_frames(robot: RobotModel, table: _Table) -> list[PinFrames]:
    """Return for each joint where the pins of a cylinder stand in the frames of the table."""
    before = [table.X_B0.inverse(), *table.frames[:-1]]
    return [
        PinFrames(X @ carrier_frame(joint, Pose()).inverse(), own)
        for joint, X, own in zip(robot.joints, before, table.frames, strict=True)
    ]


def _branching(robot: RobotModel) -> Iterator[str]:
    """Yield why no table can be made of the joints of a robot."""
    if {joint.type for joint in robot.joints} - {JointType.REVOLUTE, JointType.PRISMATIC}:
        yield "joints of other types"
    if [joint.parent for joint in robot.joints] != list(range(-1, len(robot.joints) - 1)):
        yield "branches"
    if robot.couplings or robot.cuts or robot.axes != tuple(range(len(robot.joints))):
        yield "joints that are no axes"
    if robot.tip != len(robot.joints) - 1:
        yield "its mechanical interface on another link than the last one"


def _losses(robot: RobotModel, undrawn: Sequence[str]) -> Iterator[Diagnostic]:
    """Yield the losses of a robot in a file; `undrawn` are bodies that are only drawn."""
    if undrawn:
        names = ", ".join(f"`{name}`" for name in undrawn)
        message = f"rods and cranks of `{robot.name}` that only follow its axes are not drawn: {names}"
        yield NOT_IN_ROBOT_FILE.at(None, message, hint="it moves as before; NIROX keeps them")
    if any(drive_keys(drive, _ANYWHERE) is None for drive in robot.drives):
        yield NOT_IN_ROBOT_FILE.at(None, f"`{robot.name}` has drives of other blocks than robot files know")
    if robot.external:
        yield NOT_IN_ROBOT_FILE.at(None, f"external axes of `{robot.name}` are written as joints of the arm")


def _origin(parameters: str, kind: str, source: str) -> dict[str, str]:
    return {"parameters": text(parameters), "kind": text(kind), "source": text(source)}


def _path_limits(limits: PublishedPathLimits | None) -> dict[str, str]:
    """Return the keys of the limits of tool paths."""
    kinds = {"acceleration": JointType.PRISMATIC, "jerk": JointType.PRISMATIC}
    given = limits.given if limits else {}
    return {
        f"path_{name}" if name in kinds else name: rate(value, kinds.get(name, JointType.REVOLUTE))
        for name, value in given.items()
    }


def _joint(found: DhRow, joint: Joint) -> dict[str, str]:
    return {
        "name": text(joint.name),
        "type": text("prismatic") if joint.type is JointType.PRISMATIC else "",
        "a": length(found.a),
        "alpha": coordinate(found.alpha, JointType.REVOLUTE),
        "d": length(found.d),
        "theta": coordinate(found.theta, JointType.REVOLUTE),
        "limits": range_text(joint.lower, joint.upper, joint.type),
        "speed": rate(joint.max_speed, joint.type),
        "acceleration": rate(joint.max_acceleration, joint.type),
        "jerk": rate(joint.max_jerk, joint.type),
        "effort": unless(joint.max_effort, 0.0),
    }


def _coupled(robot: RobotModel, axes: Sequence[CoupledAxis], joint: int) -> dict[str, str]:
    """Return the keys of a row that is coupled with others."""
    for axis in axes:
        if axis.joint == joint:
            names = {text(robot.joints[other].name): number(factor) for other, factor in axis.others}
            type_, bounded = robot.joints[joint].type, isfinite(axis.lower) and isfinite(axis.upper)
            limits = row(coordinate(one, type_) for one in (axis.lower, axis.upper)) if bounded else ""
            return {"coupled": inline(names), "joint_limits": limits}
    return {}


def _body(link: Link, X_FJ: Pose) -> dict[str, str]:
    R = snapped(X_FJ.rotation())
    com, inertia = R @ link.com + X_FJ.position, R @ link.inertia @ R.T
    entries = (inertia[k] for k in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))
    return {
        "mass": number(link.mass),
        "com": row(map(length, com.tolist())),
        "inertia": row(number(float(np.round(one, 15))) for one in entries),
    }


def _looks(link: Link, X_FJ: Pose) -> dict[str, str]:
    return {"shapes": shapes_text([replace(shape, pose=X_FJ @ shape.pose) for shape in link.shapes])}


def _rows(tables: Sequence[dict[str, str]]) -> str:
    """Return a list of inline tables, each on a line of its own; nothing for none."""
    return "[\n" + "".join(f"  {inline(one)},\n" for one in tables) + "]" if tables else ""
