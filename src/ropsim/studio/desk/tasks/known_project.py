"""The knowledge of a project, kept as long as its cell, its tasks and its lists of points stay."""

import hashlib
from collections.abc import Hashable, Mapping
from pathlib import Path

from ropsim.core import Diagnostic, frozen_dataclass, read_bytes
from ropsim.model import Cell
from ropsim.spatial import Pose
from ropsim.tasks import Point, PointList, point_files, read_point_lists
from ropsim.workbench import CellGeometry, Knowledge, Project, knowledge_of


@frozen_dataclass
class KnownProject:
    """Data of a project.

    Attributes:
        key: key of its inputs; the data are valid while it is the same.
        cell: None where it is broken.
        knowledge: its tasks and facts at the start.
        lists: of points.
        findings: of cell, tasks and lists.
        geometry: of the cell.
        poses: X_BT of requested points, None without a pose.
    """

    key: Hashable
    cell: Cell | None
    knowledge: Knowledge
    lists: Mapping[str, PointList]
    findings: tuple[Diagnostic, ...]
    geometry: CellGeometry | None
    poses: dict[Point, Pose | None]

    def pose(self, point: Point) -> Pose | None:
        """Return X_BT of a point, None where it has no pose."""
        if point not in self.poses:
            self.poses[point] = self.geometry.pose(point) if self.geometry is not None else None
        return self.poses[point]


def known_project(project: Project, key: Hashable) -> KnownProject:
    """Return the data of a project; a new Prolog is started for it."""
    knowledge = knowledge_of(project)
    lists, findings = read_point_lists(project.folder)
    cell = project.cell
    geometry = CellGeometry(cell) if cell is not None else None
    return KnownProject(key, cell, knowledge, lists, (*knowledge.findings, *findings), geometry, {})


def key_of(project: Project) -> Hashable:
    """Return a key that changes with cell, tasks and lists of points."""
    robots = tuple(one.text for one in project.robot_files.values())
    lists = tuple(map(_content, point_files(project.folder)))
    return project.folder, project.cell_text, robots, project.tasks, lists


def _content(path: Path) -> Hashable:
    """Return a key that changes with the content of a list."""
    try:
        return path, hashlib.sha256(read_bytes(path)).digest()
    except OSError:
        return path
