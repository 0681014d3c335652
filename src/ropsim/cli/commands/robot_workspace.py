"""`ropsim robot workspace`: reach of arms, and whether the points of a task are in it."""

import argparse
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.cli.terminal.workspace_document import study_document
from ropsim.core import Category, Diagnostic, RopsimError, Severity, define, replace_file
from ropsim.model import RobotModel
from ropsim.records import diagnostic_document
from ropsim.spatial import Pose, quaternion
from ropsim.userfiles import read_text_file
from ropsim.workbench import RobotFileError, find_robot
from ropsim.workspace import (
    NO_SURFACE,
    Candidate,
    PointKind,
    Study,
    SweepKind,
    TaskPoint,
    placements,
    size_of,
    studied,
)

WRONG_FRAME = define(
    "U904",
    "wrong-number-of-coordinates-of-a-frame",
    Severity.ERROR,
    "a tool or a base on the command line has the wrong count of numbers",
    """
`--tool X Y Z [ROLL PITCH YAW]` is where the TCP is in the frame of the flange, `--base X Y Z [YAW]` where the
base of the robot stands in the frame of the points, both in millimetres and degrees. `--base` may stand
several times. Put the names of the robots before these options.
""",
    Category.USAGE,
)
_PROJECTS = (".toml", ".task", ".icr")
"""Endings of files that contain a project."""
ACROSS = 11
"""Places along a side of the grid of `--place`."""


class FrameError(RopsimError):
    """A tool or base with the wrong count of numbers."""


def workspace(options: argparse.Namespace, output: Output) -> int:
    """Print the workspaces of robots, and their results for the points of a task."""
    tool, bases = _tool(options.tool), [_base(one) for one in options.base or [[0.0, 0.0, 0.0]]]
    points, found = _points(options.points, tool, output)
    robots = [_robot(name, output) for name in options.names]
    if any(one is None for one in robots) or (options.points and not points):
        output.document({"ok": False, **diagnostic_document(found)})
        return 1
    known = [one for one in robots if one is not None]
    candidates = _candidates(known, bases, points if options.place else (), tool)
    kind = PointKind(options.point.replace("-", " ")) if options.point else PointKind.FLANGE
    study = studied(candidates, PointKind.TCP if options.tool and not options.point else kind, tool, points)
    findings_of_arms = [one for arm in study.arms for one in arm.findings]
    findings_of_arms += _without_surface(study) if options.surface else []
    code = output.findings(findings_of_arms, {})
    from ropsim.views import workspace_text

    output.text(workspace_text(study, output.style))
    _write(options, study, output)
    missed = bool(study.standings) and study.standings[0].reached < len(points)
    code = max(code, int(missed), int(any(one.is_error for one in found)))
    output.document(
        {"ok": code == 0, **study_document(study), **diagnostic_document((*found, *findings_of_arms))}
    )
    return code


def _robot(name: str, output: Output) -> RobotModel | None:
    asked = find_robot(name)
    output.findings(asked.findings, {asked.text.name: asked.text} if asked.text else {})
    return asked.robot


def _points(
    name: str | None, tool: Pose, output: Output
) -> tuple[tuple[TaskPoint, ...], tuple[Diagnostic, ...]]:
    """Return the points of a file or of a program, and its findings, which are reported."""
    if not name:
        return (), ()
    if Path(name).is_dir() or Path(name).suffix.lower() in _PROJECTS:
        return _points_of_program(name, tool, output)
    from ropsim.workspace import read_points

    text, found = read_text_file(Path(name), name)
    points: tuple[TaskPoint, ...] = ()
    if text is not None:
        points, found = read_points(text)
    output.findings(found, {text.name: text} if text else {})
    return points, found


def _points_of_program(
    name: str, tool: Pose, output: Output
) -> tuple[tuple[TaskPoint, ...], tuple[Diagnostic, ...]]:
    """Return the points to which the program of a project moves, and its findings."""
    from ropsim.workbench import open_project, program_points

    project = open_project(name)
    points, found = program_points(project, tool)
    output.findings(found, {text.name: text for text in project.sources.values()})
    return points, found


def _candidates(
    robots: Sequence[RobotModel], bases: Sequence[Pose], around: Sequence[TaskPoint], tool: Pose
) -> list[Candidate]:
    """Return each robot at each base; with points to be placed around, also on a grid of bases."""
    made = []
    for robot in dict.fromkeys(robots):
        places = list(bases)
        if around:
            places += placements(around, size_of(robot, tool), float(bases[0].position[2]), ACROSS)
        several = len(places) > 1
        made += [Candidate(robot, X, f"{robot.name}{_place_text(X) if several else ''}") for X in places]
    return made


def _place_text(X: Pose) -> str:
    x, y, z = (round(1e3 * float(value)) for value in X.position)
    w, i, j, k = (float(value) for value in X.orientation)
    yaw = math.degrees(quaternion.to_zyx((w, i, j, k))[0]) + 0.0
    turned = f" turned {yaw:.0f}°" if abs(yaw) > 0.5 else ""
    return f" at {x} {y} {z} mm{turned}"


def _tool(numbers: Sequence[float] | None) -> Pose:
    if not numbers:
        return Pose()
    if len(numbers) not in (3, 6):
        message = f"--tool has {len(numbers)} numbers, allowed are 3 (X Y Z) or 6 (X Y Z ROLL PITCH YAW)"
        raise FrameError(WRONG_FRAME.at(None, message))
    roll, pitch, yaw = (math.radians(one) for one in (*numbers[3:], 0.0, 0.0, 0.0)[:3])
    return Pose(np.array(numbers[:3]) / 1e3, np.array(quaternion.from_zyx(yaw, pitch, roll)))


def _base(numbers: Sequence[float]) -> Pose:
    if len(numbers) not in (3, 4):
        message = f"--base has {len(numbers)} numbers, allowed are 3 (X Y Z) or 4 (X Y Z YAW)"
        raise FrameError(WRONG_FRAME.at(None, message))
    yaw = math.radians((*numbers, 0.0)[3])
    return Pose(np.array(numbers[:3]) / 1e3, np.array(quaternion.from_zyx(yaw, 0.0, 0.0)))


def _write(options: argparse.Namespace, study: Study, output: Output) -> None:
    """Write the requested files."""
    if options.report:
        from ropsim.views import workspace_page

        _replace(options.report, workspace_page(study).encode("utf-8"), output)
    if options.surface and study.arms[0].workspace and not _without_surface(study):
        from ropsim.meshes import stl_bytes
        from ropsim.workspace import surface

        points, faces = surface(study.arms[0].workspace)
        _replace(options.surface, stl_bytes(1e3 * points, faces), output)


def _without_surface(study: Study) -> list[Diagnostic]:
    """Return why the workspace of the first robot has no surface; empty if it has a surface."""
    space = study.arms[0].workspace
    if space is None or (space.volume > 0.0 and space.sweep.kind is not SweepKind.FLAT):
        return []
    return [
        NO_SURFACE.at(None, f"the workspace of `{study.arms[0].robot.name}` has no surface, only an area")
    ]


def _replace(path: str, content: bytes, output: Output) -> None:
    try:
        replace_file(Path(path), content)
    except OSError as error:
        raise RobotFileError(cannot_write(path, error)) from error
    output.text(f"wrote {path}")
