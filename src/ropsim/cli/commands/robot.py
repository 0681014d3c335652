"""`ropsim robot`: the model library on the command line; degrees and millimetres."""

import argparse
import math
import textwrap
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import numpy as np

from ropsim import kinematics, robots
from ropsim.cli.terminal.coordinates import check_coordinates, display, joint_coordinates, shown
from ropsim.cli.terminal.drive_words import drive_lines
from ropsim.cli.terminal.named_robot import asked_robot, named_robot, requested, say_tip, tip_name
from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.cli.terminal.solver_words import solver_document, solver_lines
from ropsim.core import Category, Diagnostic, RopsimError, Severity, define, replace_file
from ropsim.model import (
    ESTIMATED_PARAMETERS,
    INDEFINITE_INERTIA,
    MASSLESS_LINK,
    TRIANGLE_VIOLATED,
    UNLIKELY_MASS,
    Joint,
    JointType,
    PlaceOf,
    RobotModel,
    coupled_limits,
)
from ropsim.model import audit as audit_model
from ropsim.records import diagnostic_document
from ropsim.spatial import quaternion
from ropsim.workbench import RobotFileError, find_robot, robots_in

WRONG_COUNT = define(
    "U901",
    "wrong-number-of-coordinates",
    Severity.ERROR,
    "a joint vector of the wrong length on the command line",
    "Give one number per joint: degrees for turning joints, millimetres for sliding ones.",
    Category.USAGE,
)

_NIROX = (".stp", ".step")
COLUMNS = 80
"""Width to which sources are wrapped."""


class JointCountError(RopsimError):
    """The command line has too many or too few joint coordinates."""


def list_(options: argparse.Namespace, output: Output) -> int:
    """List the built-in robots, and the robot files of a project."""
    known = {one.name: one for one in robots.catalogue()}
    files = {str(path): find_robot(path).robot for path in robots_in(Path(options.path))}
    width = max(map(len, known))
    rows = [f"{'name':{width}} {'axes':>6}  {'wrist':>8}  {'payload':>8}  maker and model"]
    rows += [f"{name:{width}} {_choice(one)}" for name, one in known.items()]
    width = max(map(len, files), default=0)  # paths are long
    for name, robot in files.items():
        summary = f"{robot.n} axes  {robot.title}" if robot else f"wrong: see ropsim robot audit {name}"
        rows.append(f"{name:{width}} {summary}")
    output.text("\n".join(rows))
    titles = {name: robot.title if robot else None for name, robot in files.items()}
    output.document({"robots": {name: one.title for name, one in known.items()}, "files": titles})
    return 0


def _choice(one: robots.CatalogueEntry) -> str:
    """Return data for choosing a robot: axes, reach, payload, maker and model."""
    payload = f"{one.rated_payload:g} kg" if math.isfinite(one.rated_payload) else "–"
    return f"{one.axes} axes  {1e3 * one.reach:5.0f} mm  {payload:>8}  {one.title}"


def show(options: argparse.Namespace, output: Output) -> int:
    """Print a model."""
    asked = asked_robot(options, output)
    robot = asked.robot
    if robot is None:
        return 1
    from ropsim.nirox import ConformanceClass, conformance_of

    class_ = conformance_of(robot)
    lines = [f"{robot.name}: {robot.title}, {robot.n} {'axis' if robot.n == 1 else 'axes'}"]
    if Path(options.name).suffix.lower() in _NIROX:
        demands = [one.value for one in ConformanceClass if one.name <= class_.name]
        lines.append(f"NIROX class {class_.name}: {', '.join(demands)}")
    lines += ["", *_joint_rows(robot), *_following(robot), *_payload(robot)]
    for text in _tool_motion(robot):
        lines += textwrap.wrap(text, COLUMNS, subsequent_indent="  ") or [""]
    lines.append("")
    for text in (*drive_lines(robot), *solver_lines(robot)):
        lines += textwrap.wrap(text, COLUMNS, subsequent_indent="  ")
    lines += ["", "where the numbers come from"]
    for one in robot.origins:
        text = f"  {one.kind:10} {one.parameters}: {one.source}"
        lines += textwrap.wrap(text, COLUMNS, subsequent_indent=" " * 13, break_on_hyphens=False)
    output.text("\n".join(lines))
    if options.png:
        _draw(robot, options.png, output)
    output.document(
        {
            "name": robot.name,
            "conformance": class_.name,
            "title": robot.title,
            "tip": tip_name(asked),
            "rated_payload": robot.rated_payload if math.isfinite(robot.rated_payload) else None,
            "tool_motion": _tool_motion_document(robot),
            "path_limits": robot.path_limits.given if robot.path_limits else None,
            "joints": [
                {"name": joint.name, "type": joint.type.value, "lower": joint.lower, "upper": joint.upper}
                for joint in robot.axis_joints
            ],
            "following": [
                {"name": joint.name, "type": joint.type.value, "lower": joint.lower, "upper": joint.upper}
                for joint in coupled_limits(robot).joints
            ],
            "inverse_kinematics": solver_document(robot),
            "origins": [[one.parameters, one.kind, one.source] for one in robot.origins],
        }
    )
    return 0


def _draw(robot: RobotModel, file: str, output: Output) -> None:
    """Write a picture of a robot in its rest position."""
    from ropsim.views import has_no_shapes, robot_png

    try:
        replace_file(Path(file), robot_png(robot))
    except OSError as error:
        raise RobotFileError(cannot_write(file, error)) from error
    remark = ": axes and rods, as pictures show no meshes and it has no other shapes"
    output.text(f"\nwrote {file}{remark if has_no_shapes(robot) else ''}")


def audit(options: argparse.Namespace, output: Output) -> int:
    """Report doubts about a model."""
    asked = find_robot(requested(options, options.name))
    say_tip(asked, output)
    doubts = _doubts(asked.robot, asked.place_of) if asked.robot else ()
    said = _said_by_reader(asked.findings)
    doubts = tuple(one for one in doubts if one.code not in said)
    found = (*asked.findings, *doubts)
    code = output.findings(found, {asked.text.name: asked.text} if asked.text else {})
    output.document({"ok": code == 0, "tip": tip_name(asked), **diagnostic_document(found)})
    return code


def _said_by_reader(findings: Iterable[Diagnostic]) -> set[str]:
    """Return the codes of an audit that say the same as findings of a reader, on estimates and masses."""
    from ropsim.exchange import DOUBTFUL_BODY, LIMIT_UNKNOWN

    same = {
        LIMIT_UNKNOWN.code: (ESTIMATED_PARAMETERS,),
        DOUBTFUL_BODY.code: (MASSLESS_LINK, INDEFINITE_INERTIA, TRIANGLE_VIOLATED, UNLIKELY_MASS),
    }
    return {kind.code for one in findings for kind in same.get(one.code, ())}


def _doubts(robot: RobotModel, place_of: PlaceOf) -> tuple[Diagnostic, ...]:
    """Return the doubts; closed chains are checked if the mechanism has no contradictions."""
    doubts = audit_model(robot, place_of)
    return doubts if any(one.is_error for one in doubts) else (*doubts, *kinematics.loop_freedom(robot))


def fk(options: argparse.Namespace, output: Output) -> int:
    """Print the pose of the mechanical interface."""
    robot = named_robot(options, output)
    if robot is None:
        return 1
    if len(options.q) != robot.n:
        message = f"`{robot.name}` has {robot.n} joints, given: {len(options.q)}"
        raise JointCountError(WRONG_COUNT.at(None, message))
    given = joint_coordinates(robot, options.q)
    check_coordinates(given)
    pose = kinematics.forward(robot, np.array([one.value for one in given]) / _scales(robot))
    x, y, z = (shown(1e3 * float(c), 3) for c in pose.position)
    w, i, j, k = (float(c) for c in pose.orientation)
    yaw, pitch, roll = (shown(math.degrees(angle), 4) for angle in quaternion.to_zyx((w, i, j, k)))
    output.text(f"x {x:.3f}  y {y:.3f}  z {z:.3f} mm   roll {roll:.4f}  pitch {pitch:.4f}  yaw {yaw:.4f} deg")
    output.document({"position": pose.position.tolist(), "orientation": pose.orientation.tolist()})
    return 0


def _following(robot: RobotModel) -> list[str]:
    """Return lines for each coupled joint with its own limits: the limits, and the range that they leave."""
    found, coupled = [""], coupled_limits(robot)
    for joint, factors, constant in zip(coupled.joints, coupled.T, coupled.c.tolist(), strict=True):
        found.append(f"joint {joint.name}, which follows the axes: {_range(joint, joint.lower, joint.upper)}")
        number = int(np.flatnonzero(factors)[-1])
        axis, factor = robot.axis_joints[number], float(factors[number])
        others = constant + float(factors @ robot.home) - factor * float(robot.home[number])
        lower, upper = sorted(((joint.lower - others) / factor, (joint.upper - others) / factor))
        left = _range(axis, max(lower, axis.lower), min(upper, axis.upper))
        found.append(f"with the other axes at home that leaves {axis.name} {left}")
    return found if len(found) > 1 else []


def _range(joint: Joint, lower: float, upper: float) -> str:
    scale, unit = display(joint.measure)
    if replace(joint, lower=lower, upper=upper).is_endless:
        return "endless"
    return f"{lower * scale:.1f} {unit} to {upper * scale:.1f} {unit}"


def _tool_motion(robot: RobotModel) -> list[str]:
    """Return a line for what the joints can do for the tool, where the robot is an arm."""
    limits = robots.path_limits_of_joints(robot)
    if limits is None:
        return []
    turning, turned = (
        f"{float(f'{np.degrees(value):.2g}'):g}"
        for value in (limits.orientation_speed, limits.orientation_acceleration)
    )
    place = f"tool, {robots.TOOL_LENGTH * 1e3:.0f} mm before the flange, amid the workspace"
    found = ["", f"{place}: {limits.acceleration:g} m/s², {turning} °/s, {turned} °/s²"]
    return [*found, *_published_limits(robot)]


def _published_limits(robot: RobotModel) -> list[str]:
    """Return a line for the limits of tool paths that the maker publishes."""
    shown = {"acceleration": "m/s²", "jerk": "m/s³"}
    turns = {"orientation_speed": "°/s", "orientation_acceleration": "°/s²", "orientation_jerk": "°/s³"}
    given = robot.path_limits.given if robot.path_limits else {}
    words = [f"{value:g} {shown[name]}" for name, value in given.items() if name in shown]
    words += [
        f"{float(f'{np.degrees(value):.3g}'):g} {turns[name]}"
        for name, value in given.items()
        if name in turns
    ]
    return [f"limits of tool paths from the maker: {', '.join(words)}"] if words else []


def _tool_motion_document(robot: RobotModel) -> dict[str, float] | None:
    limits = robots.path_limits_of_joints(robot)
    if limits is None:
        return None
    return {
        "acceleration": limits.acceleration,
        "orientation_speed": limits.orientation_speed,
        "orientation_acceleration": limits.orientation_acceleration,
    }


def _payload(robot: RobotModel) -> list[str]:
    """Return a line for the rated payload, where it is known."""
    if not math.isfinite(robot.rated_payload):
        return []
    return ["", f"rated payload, tool and part together: {robot.rated_payload:g} kg"]


def _joint_rows(robot: RobotModel) -> list[str]:
    """Return a table of the joints with its header: numbers aligned right below their titles."""
    rows = [("joint", "type", "lower", "upper", "speed", "acceleration", "torque or force")]
    for joint in robot.axis_joints:
        scale, unit = display(joint.measure)
        rows.append(
            (
                joint.name,
                joint.type.value,
                "endless" if joint.is_endless else f"{joint.lower * scale:.1f} {unit}",
                "endless" if joint.is_endless else f"{joint.upper * scale:.1f} {unit}",
                f"{joint.max_speed * scale:.1f} {unit}/s",
                f"{joint.max_acceleration * scale:.0f} {unit}/s²",
                _effort(joint),
            )
        )
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return ["  ".join(map(_cell, row, widths, "<<>>>>>")) for row in rows]


def _cell(text: str, width: int, side: str) -> str:
    return f"{text:{side}{width}}"


def _effort(joint: Joint) -> str:
    if not math.isfinite(joint.max_effort):
        return "unknown"
    return f"{joint.max_effort:.1f} {'N·m' if joint.measure is JointType.REVOLUTE else 'N'}"


def _scales(robot: RobotModel) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    return np.array([display(joint.measure)[0] for joint in robot.axis_joints])
