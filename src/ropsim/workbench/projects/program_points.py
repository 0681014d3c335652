"""Where a program goes, as the points of a task: for other arms, and other places of the base."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from ropsim import icr
from ropsim.core import Diagnostic, plural
from ropsim.flow import MoveInstruction
from ropsim.model import Station
from ropsim.spatial import Array, Pose
from ropsim.workbench.compiling.dry_arm import program_arm
from ropsim.workbench.compiling.environment import environment_of
from ropsim.workbench.compiling.resolved import BUDGET
from ropsim.workbench.projects.project import Project

if TYPE_CHECKING:  # loaded on request
    from ropsim.workspace import TaskPoint

_DIGITS = 9  # of metres and quaternions that make two points different


def program_points(
    project: Project, X_MT: Pose | None = None
) -> tuple[tuple["TaskPoint", ...], tuple[Diagnostic, ...]]:
    """Return the targets of the program of the first station, and findings on omitted or wrong ones.

    The targets come from a dry run; targets and via points of arcs and curves count, each once, under the
    line that goes there first. The pose of the flange is that of the program, independent of the tool; where
    the orientation is free, the tool may come to the point in any.

    Args:
        project: with a cell.
        X_MT: tool frame in the frame of the mechanical interface that is to be at the points; None for none.

    Returns:
        Points in the base frame of the station.

    Raises:
        ProjectError: the project is broken, or the program does not exist.
    """
    from ropsim.workspace import NO_POINTS, POINTS_LEFT_OUT, TaskPoint

    programs = project.programs()
    if project.cell is None or not programs:
        return (), (NO_POINTS.at(None, f"`{project.folder}` has no cell with a program"),)
    name, compiled = next(iter(programs.items()))
    if compiled.icr is None:
        return (), compiled.diagnostics
    station = project.cell.stations[name]
    found: dict[tuple[float, ...], TaskPoint] = {}
    left = 0
    lines: dict[str, int] = {}
    world = icr.StillWorld(arm=program_arm(compiled.icr, project.cell, station))
    for move in icr.run(compiled.icr, world, BUDGET).moves:
        points = tuple(_points(project, station, move, X_MT or Pose()))
        left += not points
        for position, orientation in points:
            turn = () if orientation is None else orientation
            key = tuple(round(float(one), _DIGITS) for one in (*position, *turn))
            if key not in found:
                label = f"line {move.origin.span.line}" if move.origin.span else "move"
                lines[label] = lines.get(label, 0) + 1
                named = f"{label} ({lines[label]})" if lines[label] > 1 else label
                found[key] = TaskPoint(named, position, orientation)
    findings: list[Diagnostic] = []
    if left:
        words = (
            f"{plural(left, 'move')} of `{name}` left out: to joint coordinates, or where external axes stand"
        )
        findings.append(POINTS_LEFT_OUT.at(None, words))
    if not found:
        findings.append(
            NO_POINTS.at(None, f"the program of `{name}` goes to no point that is known before it runs")
        )
    return tuple(found.values()), tuple(findings)


def _points(
    project: Project, station: Station, move: MoveInstruction, X_MT: Pose
) -> Iterator[tuple[Array, Array | None]]:
    """Yield position and orientation of a tool at the target and at the points on the way of a move.

    None where they are not known beforehand; without orientation where that is free.
    """
    if not isinstance(move.target, Pose) or move.external:
        return
    if move.modal.frame in environment_of(project.cell, station).moving:
        return
    back = (move.modal.X_MT or Pose()).inverse()
    for pose in (*move.via, move.target):
        X_BT = move.modal.X_BK @ pose
        if move.has_free_orientation:
            yield X_BT.position, None
        else:
            X_BT = X_BT @ back @ X_MT
            yield X_BT.position, X_BT.orientation
