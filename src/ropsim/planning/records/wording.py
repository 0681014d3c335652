"""Wording of the controller's findings: coordinates with units, loop passes."""

import math

from ropsim.flow import Origin
from ropsim.kinematics import Reach, Shortfall
from ropsim.model import Joint, JointType, RobotModel
from ropsim.spatial import Array


def coordinate(joint: Joint, value: float) -> str:
    """Return a joint coordinate [rad | m] in degrees or millimetres, as people read it."""
    if joint.measure is JointType.REVOLUTE:
        return f"{math.degrees(value):.1f}°"
    return f"{value * 1e3:.1f} mm"


def rate(joint: Joint, value: float, per: str) -> str:
    """Return a joint speed or acceleration in degrees or millimetres; `per` is `/s` or `/s²`."""
    if joint.measure is JointType.REVOLUTE:
        return f"{math.degrees(value):.1f}°{per}"
    return f"{value * 1e3:.1f} mm{per}"


def passes(origin: Origin) -> str:
    """Return to which point of a list, or in which loop pass, an instruction leads; empty for the first."""
    if origin.point:
        return str(origin.point)
    return f"reached in pass {origin.visit}" if origin.visit > 1 else ""


def external_notes(robot: RobotModel, q: Array) -> tuple[str, ...]:
    """Return a note on where the external axes of an arm stand, empty without any.

    Args:
        robot: the arm with its external axes.
        q: joint coordinates [rad | m], shape (n,).
    """
    if not robot.external or not robot.has_arm:
        return ()
    axes = [(robot.axis_joints[k], float(q[k])) for k in robot.external]
    return (f"external axes stand at {', '.join(f'{one.name} = {_plain(one, at)}' for one, at in axes)}",)


def _plain(joint: Joint, value: float) -> str:
    """Return a joint coordinate [rad | m] with as many digits as it needs."""
    if joint.measure is JointType.REVOLUTE:
        return f"{math.degrees(value):.6g}°"
    return f"{value * 1e3:.6g} mm"


def figures(joint: Joint, value: float, limit: float, per: str = "") -> dict[str, object]:
    """Return name, value and limit of a joint for the data of a finding; the keys carry the unit."""
    unit = ("rad" if joint.measure is JointType.REVOLUTE else "m") + per
    return {"joint": joint.name, f"value_{unit}": value, f"limit_{unit}": limit}


def shortfall_words(shortfall: Shortfall) -> str:
    """Return the words on the shortfall of a pose; empty if unknown."""
    if shortfall.reach:
        return _distance_words(shortfall.reach)
    miss = shortfall.miss
    if miss is None:
        return ""
    parts = [f"{miss.distance * 1e3:.2f} mm"] if miss.distance > 0.0 else []
    parts += [f"{math.degrees(miss.angle):.2f}°"] if miss.angle > 0.0 else []
    return f"{miss.why}; {' and '.join(parts)} from it to the pose" if parts else miss.why


def _distance_words(reach: Reach) -> str:
    """Return how far the point that decides would be, and how far or near it may be."""
    found = f"the {reach.point} is {reach.distance * 1e3:.2f} mm from axis {reach.axis}"
    if reach.distance > reach.longest:
        return f"{found}, the arm reaches {reach.longest * 1e3:.2f} mm"
    return f"{found}, the arm cannot come nearer than {reach.shortest * 1e3:.2f} mm"
