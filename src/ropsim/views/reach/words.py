"""The figures of a workspace in the words and units of people."""

import math

from ropsim.model import Joint, JointType, RobotModel
from ropsim.workspace import DIRECTIONS, ArmStudy, PointCheck, Reachable, SweepKind

LEAST, LEAST_ANGLE = 5e-5, 1e-3
"""Misses below this [m, rad] are not reported."""


def volume_text(volume: float, error: float, unit: str) -> str:
    """Return a volume with its error, with the digits that the error leaves."""
    if volume == 0.0:
        return "none"
    digits = max(0, min(6, 1 - math.floor(math.log10(error)))) if error > 0.0 else 4
    return f"{volume:.{digits}f} {unit} ± {error:.{digits}f}"


def extent_texts(workspace: Reachable) -> tuple[tuple[str, str], ...]:
    """Return the extremes of a workspace: names, and ranges [mm]."""
    ends = [f"{1e3 * one.value + 0.0:.1f}" for one in workspace.extremes]
    names = {
        SweepKind.TURN: ("radius from axis 1", "height above the base"),
        SweepKind.SLIDE: ("first coordinate across axis 1", "second coordinate across axis 1"),
        SweepKind.FLAT: ("first coordinate in the plane", "second coordinate in the plane"),
    }[workspace.sweep.kind]
    return (names[0], f"{ends[0]} to {ends[1]} mm"), (names[1], f"{ends[2]} to {ends[3]} mm")


def dexterity_texts(study: ArmStudy) -> tuple[tuple[str, str], ...]:
    """Return in which directions the tool can point; none where that was not computed."""
    turned = study.dexterity
    if turned is None:
        return ()
    if turned.directions.count == 1:
        return (("tool as at home", volume_text(turned.volume, turned.error, "m³")),)
    count = turned.directions.count
    return (
        (f"all of {count} tool directions", volume_text(turned.volume, turned.error, "m³")),
        ("half of them or more", volume_text(turned.half, turned.half_error, "m³")),
    )


def left_text(robot: RobotModel, check: PointCheck) -> str:
    """Return the margin to the nearest limit of a joint."""
    if check.reach is None:
        return "–"
    margin = check.reach.margin
    if margin.joint < 0:
        return "no limits"
    joint = robot.axis_joints[margin.joint]
    return f"{_measured(joint, margin.left)} (joint {joint.name})"


def miss_text(check: PointCheck) -> str:
    """Return why a point is not reached, and the distance missed."""
    if check.miss is None:
        return ""
    beyond = [f"joint {one.name} by {_measured(one.model, one.excess)}" for one in check.miss.violations]
    if beyond:
        return f"beyond limits: {', '.join(beyond)}"
    missing = [f"{1e3 * check.miss.distance:.1f} mm"] if check.miss.distance > LEAST else []
    if check.miss.angle > LEAST_ANGLE:
        missing.append(f"{math.degrees(check.miss.angle):.1f}°")
    return f"{check.miss.why}; {' and '.join(missing)} missing" if missing else check.miss.why


def _measured(joint: Joint, value: float) -> str:
    """Return a part of the coordinate of a joint, in degrees or millimetres."""
    if joint.measure is JointType.REVOLUTE:
        return f"{math.degrees(value):.1f}°"
    return f"{1e3 * value:.1f} mm"


def way_text(check: PointCheck) -> str:
    """Return how a point is reached: the posture, and in how many directions where any will do."""
    if check.reach is None:
        return miss_text(check)
    name = check.reach.posture or "reached"
    return name if check.directions is None else f"{name}, {check.directions} of {DIRECTIONS} directions"
