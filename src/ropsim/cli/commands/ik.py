"""`ropsim robot ik`: every posture that reaches a pose, and the limits that the others exceed."""

import argparse
import math
from collections.abc import Iterator, Sequence

import numpy as np

from ropsim import kinematics
from ropsim.cli.terminal.coordinates import Coordinate, check_coordinates, display, shown
from ropsim.cli.terminal.named_robot import named_robot
from ropsim.cli.terminal.output import Output
from ropsim.cli.terminal.solver_words import free_line, remarks, solver_document
from ropsim.core import frozen_dataclass
from ropsim.kinematics import (
    Free,
    FreeInterval,
    IkOptions,
    IkResult,
    Limits,
    LimitViolation,
    Nearest,
    Posture,
)
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, Pose, quaternion

_WIDTH = 9
_POSE = {
    **dict.fromkeys(("x", "y", "z"), JointType.PRISMATIC),
    **dict.fromkeys(("roll", "pitch", "yaw"), JointType.REVOLUTE),
}
_ALL = IkOptions(limits=Limits.IGNORE)


@frozen_dataclass
class _Branch:
    """One joint solution; joint coordinates `q` [rad | m], shape (n,)."""

    q: Array
    posture: Posture
    beyond: tuple[LimitViolation, ...] = ()


def ik(options: argparse.Namespace, output: Output) -> int:
    """Print every joint vector that reaches a pose: first those inside the limits, then those beyond."""
    robot = named_robot(options, output)
    if robot is None:
        return 1
    check_coordinates(Coordinate(f"`{name}`", kind, getattr(options, name)) for name, kind in _POSE.items())
    turn = quaternion.from_zyx(*(math.radians(angle) for angle in (options.yaw, options.pitch, options.roll)))
    pose = Pose(np.array([options.x, options.y, options.z]) / 1e3, np.array(turn))
    result = kinematics.inverse(robot, pose)
    beyond = list(_beyond(robot, kinematics.inverse(robot, pose, _ALL)))
    inside = [_Branch(q, one) for q, one in zip(result.solutions, result.postures, strict=True)]
    if inside or beyond:
        output.text("\n".join(_table(robot, [*inside, *beyond])))
    if not inside:
        output.text(_why_none(result))
    beside = kinematics.nearest(robot, pose) if result.shortfall is not None else None
    if beside is not None:
        output.text(_nearest_line(beside))
    intervals = kinematics.free_intervals(robot, pose)
    if result.free is not None:
        output.text(free_line(result.free, intervals))
    for line in remarks(robot):
        output.text(line)
    output.document(
        {
            "status": result.status.value,
            "solutions": result.solutions.tolist(),
            "postures": [str(one) for one in result.postures],
            "beyond_limits": [_entry(one) for one in beyond],
            "nearest": beside and _nearest_entry(beside),
            "free": result.free and _free_entry(result.free, intervals),
            "solver": solver_document(robot),
        }
    )
    return 0 if inside else 1


def _beyond(robot: RobotModel, result: IkResult) -> Iterator[_Branch]:
    for q, posture in zip(result.solutions, result.postures, strict=True):
        violations = kinematics.limit_violations(robot, q)
        if violations:
            yield _Branch(kinematics.turned_to_limits(robot, q), posture, violations)


def _table(robot: RobotModel, branches: Sequence[_Branch]) -> list[str]:
    shows = [display(joint.measure) for joint in robot.axis_joints]
    names = [f"{joint.name} [{unit}]" for joint, (_, unit) in zip(robot.axis_joints, shows, strict=True)]
    rows = [(*names, "posture", "beyond its limits" if any(one.beyond for one in branches) else "")]
    for one in branches:
        values = [f"{shown(q * scale, 3):.3f}" for q, (scale, _) in zip(one.q, shows, strict=True)]
        rows.append((*values, str(one.posture), ", ".join(_excess(joint) for joint in one.beyond)))
    longest = max(len(row[-2]) for row in rows)
    return [
        "  ".join(f"{cell:>{_WIDTH}}" for cell in row[:-2]) + f"   {row[-2]:{longest}}  {row[-1]}".rstrip()
        for row in rows
    ]


def _excess(beyond: LimitViolation) -> str:
    scale, unit = display(beyond.model.measure)
    space = "" if unit == "°" else " "
    return f"joint {beyond.name} by {beyond.excess * scale:.1f}{space}{unit}"


def _why_none(result: IkResult) -> str:
    if result.shortfall is None:
        return "no solution inside the limits"
    reach, miss = result.reach, result.shortfall.miss
    if miss is not None:
        missing = f"{miss.distance * 1e3:.1f} mm and {math.degrees(miss.angle):.1f}° are missing"
        return f"no solution: {result.status.value}; {miss.why}, {missing}"
    if reach is None:
        return f"no solution: {result.status.value}"
    least, most = f"{reach.shortest * 1e3:.1f} mm", f"{reach.longest * 1e3:.1f} mm"
    allowed = f"at least {least}" if math.isinf(reach.longest) else f"{least} to {most}"
    distance = f"{reach.distance * 1e3:.1f} mm from axis {reach.axis}"
    return f"no solution: out of reach; the {reach.point} would be {distance}, possible is {allowed}"


def _nearest_line(beside: Nearest) -> str:
    """Return the pose that comes nearest and how far it is away, for people."""
    x, y, z = (shown(1e3 * value, 1) for value in beside.pose.position)
    w, i, j, k = beside.pose.orientation
    yaw, pitch, roll = (shown(math.degrees(angle), 1) for angle in quaternion.to_zyx((w, i, j, k)))
    place = f"x {x:.1f}  y {y:.1f}  z {z:.1f} mm   roll {roll:.1f}  pitch {pitch:.1f}  yaw {yaw:.1f} deg"
    return f"nearest: {place}, {beside.distance * 1e3:.1f} mm and {math.degrees(beside.angle):.1f}° away"


def _nearest_entry(beside: Nearest) -> dict[str, object]:
    return {
        "q": beside.q.tolist(),
        "position": beside.pose.position.tolist(),
        "orientation": beside.pose.orientation.tolist(),
        "distance": beside.distance,
        "angle": beside.angle,
    }


def _free_entry(free: Free, intervals: Sequence[FreeInterval]) -> dict[str, object]:
    return {
        "name": free.name,
        "value": free.value,
        "intervals": [[one.lower, one.upper] for one in intervals],
    }


def _entry(branch: _Branch) -> dict[str, object]:
    return {
        "q": branch.q.tolist(),
        "posture": str(branch.posture),
        "exceeds": [
            {"joint": one.name, "value": one.value, "limit": one.limit, "excess": one.excess}
            for one in branch.beyond
        ],
    }
