"""`ropsim robot`: the model library on the command line; degrees and millimetres."""

import argparse
import math

import numpy as np

from ropsim import kinematics, robots
from ropsim.cli.numbers import shown
from ropsim.cli.output import Output
from ropsim.core import RopsimError, Severity, define
from ropsim.model import Joint, JointType, RobotModel
from ropsim.model import audit as audit_model
from ropsim.spatial.quaternion import to_zyx
from ropsim.workbench.diagnostic_json import diagnostic_document

WRONG_COUNT = define(
    "U901",
    "wrong-number-of-coordinates",
    Severity.ERROR,
    "a joint vector of the wrong length on the command line",
    "Give one number per joint: degrees for turning joints, millimetres for sliding ones.",
)


class JointCountError(RopsimError):
    """The command line gives too many or too few joint coordinates."""


def list_(options: argparse.Namespace, output: Output) -> int:
    """List the built-in robots."""
    del options
    models = {name: robots.load(name) for name in robots.names()}
    output.text("\n".join(f"{name:12} {model.n} axes  {model.title}" for name, model in models.items()))
    output.document({"robots": {name: model.title for name, model in models.items()}})
    return 0


def show(options: argparse.Namespace, output: Output) -> int:
    """Print a model."""
    robot = robots.load(options.name)
    lines = [
        f"{robot.name}: {robot.title}, {robot.n} axes",
        "",
        "joint  type       range                speed      acceleration  torque",
    ]
    for joint in robot.joints:
        scale, unit = _display(joint.type)
        lines.append(
            f"{joint.name:6} {joint.type.value:10}"
            f" {joint.lower * scale:7.1f} .. {joint.upper * scale:6.1f} {unit:4}"
            f" {joint.max_speed * scale:7.1f} {unit}/s {joint.max_acceleration * scale:7.0f} {unit}/s²"
            f" {_effort(joint)}"
        )
    lines += ["", "where the numbers come from"]
    lines += [f"  {one.kind:10} {one.parameters}: {one.source}" for one in robot.origins]
    output.text("\n".join(lines))
    output.document(
        {
            "name": robot.name,
            "title": robot.title,
            "joints": [
                {"name": joint.name, "type": joint.type.value, "lower": joint.lower, "upper": joint.upper}
                for joint in robot.joints
            ],
            "origins": [[one.parameters, one.kind, one.source] for one in robot.origins],
        }
    )
    return 0


def audit(options: argparse.Namespace, output: Output) -> int:
    """Say what is doubtful in a model."""
    found = audit_model(robots.load(options.name))
    code = output.findings(found, {})
    output.document({"ok": code == 0, **diagnostic_document(found)})
    return code


def fk(options: argparse.Namespace, output: Output) -> int:
    """Print the pose of the mechanical interface."""
    robot = robots.load(options.name)
    if len(options.q) != robot.n:
        message = f"`{robot.name}` has {robot.n} joints, {len(options.q)} coordinates were given"
        raise JointCountError(WRONG_COUNT.at(None, message))
    pose = kinematics.forward(robot, np.array(options.q) / _scales(robot))
    x, y, z = (shown(1e3 * float(c), 3) for c in pose.position)
    w, i, j, k = (float(c) for c in pose.orientation)
    yaw, pitch, roll = (shown(math.degrees(angle), 4) for angle in to_zyx((w, i, j, k)))
    output.text(f"x {x:.3f}  y {y:.3f}  z {z:.3f} mm   roll {roll:.4f}  pitch {pitch:.4f}  yaw {yaw:.4f} deg")
    output.document({"position": pose.position.tolist(), "orientation": pose.orientation.tolist()})
    return 0


def _effort(joint: Joint) -> str:
    if not math.isfinite(joint.max_effort):
        return "  unknown"
    return f"{joint.max_effort:9.1f} {'N·m' if joint.type is JointType.REVOLUTE else 'N'}"


def _display(kind: JointType) -> tuple[float, str]:
    return (math.degrees(1.0), "°") if kind is JointType.REVOLUTE else (1e3, "mm")


def _scales(robot: RobotModel) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    return np.array([_display(joint.type)[0] for joint in robot.joints])
