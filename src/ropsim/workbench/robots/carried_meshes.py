"""Meshes of a robot that moves into a project: copied beside its file, and named by their new paths."""

import re
import shutil
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path, PurePosixPath

from ropsim.core import frozen_dataclass
from ropsim.model import Mesh, RobotModel, Shape

_ROBOTS = "robots"


@frozen_dataclass
class CarriedRobot:
    """A robot whose meshes are at new places.

    Attributes:
        robot: with the new paths, which count from the project folder.
        copies: sources of the meshes by their new paths.
    """

    robot: RobotModel
    copies: Mapping[str, Path]

    def copy(self, project: Path) -> None:
        """Copy the meshes into a project.

        Raises:
            OSError: a file cannot be read or written.
        """
        for path, source in self.copies.items():
            target = project / path
            if target.exists() and target.samefile(source):
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target)


def project_of_robot(file: Path) -> Path:
    """Return the folder from which the paths in a robot file count: that of its project."""
    home = file.resolve().parent
    return home.parent if home.name == _ROBOTS else home


def carried(robot: RobotModel, root: Path, file: Path) -> CarriedRobot:
    """Return a robot with its meshes in the folder `meshes` beside a file; in its own project they stay.

    Args:
        robot: its mesh paths count from `root`.
        root: folder.
        file: new file of the robot, in a project.
    """
    if root.resolve() == project_of_robot(file):
        return CarriedRobot(robot, {})
    beside = file.resolve().parent.relative_to(project_of_robot(file)).as_posix()
    stem = plain_name(file)
    folder = f"meshes/{stem}" if beside == "." else f"{beside}/meshes/{stem}"
    paths: dict[str, str] = {}
    taken: set[str] = set()
    for mesh in _meshes(robot):
        if mesh.file not in paths:
            paths[mesh.file] = f"{folder}/{_unused(PurePosixPath(mesh.file), taken)}"
    moved = replace(
        robot,
        base_shapes=_moved(robot.base_shapes, paths),
        links=tuple(replace(link, shapes=_moved(link.shapes, paths)) for link in robot.links),
    )
    return CarriedRobot(moved, {path: root / old for old, path in paths.items()})


def plain_name(file: Path) -> str:
    """Return the name of a robot after its file: `ur5e` for `ur5e.urdf.xacro`."""
    return re.sub(r"[^\w-]", "_", file.name.partition(".")[0]) or "robot"


def _meshes(robot: RobotModel) -> list[Mesh]:
    shapes = (*robot.base_shapes, *(shape for link in robot.links for shape in link.shapes))
    return [shape.solid for shape in shapes if isinstance(shape.solid, Mesh)]


def _unused(path: PurePosixPath, taken: set[str]) -> str:
    """Return the name of a mesh file, with a number where another one has it."""
    name, number = path.name, 1
    while name.lower() in taken:
        number += 1
        name = f"{path.stem}_{number}{path.suffix}"
    taken.add(name.lower())
    return name


def _moved(shapes: tuple[Shape, ...], paths: Mapping[str, str]) -> tuple[Shape, ...]:
    return tuple(
        replace(shape, solid=replace(shape.solid, file=paths[shape.solid.file]))
        if isinstance(shape.solid, Mesh)
        else shape
        for shape in shapes
    )
