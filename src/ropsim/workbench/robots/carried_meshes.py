"""Meshes of a robot that moves into a project: copied beside its file, and named by their new paths."""

import os
import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path, PurePosixPath

from ropsim.core import frozen_dataclass, read_bytes, replace_file
from ropsim.model import LARGEST_MESH, Mesh, RobotModel, Shape
from ropsim.workbench.robots.robot_formats import MESHES_FROM_FILE

_ROBOTS = "robots"


@frozen_dataclass
class CarriedRobot:
    """A robot whose meshes are at new places.

    Attributes:
        robot: with the new paths, as the format of its file counts them.
        copies: sources of the meshes by their new paths, which count from the project folder.
    """

    robot: RobotModel
    copies: Mapping[str, Path]

    def copy(self, project: Path) -> None:
        """Copy the meshes into a project.

        Raises:
            OSError: a file cannot be read or written, or is larger than a mesh may be.
        """
        for path, source in self.copies.items():
            target = project / path
            if target.exists() and target.samefile(source):
                continue
            content = read_bytes(source, LARGEST_MESH)
            if target.is_symlink():  # its target is another file of the user
                target.unlink()
            replace_file(target, content)


def project_of_robot(file: Path) -> Path:
    """Return the folder from which the paths in a robot file count: that of its project."""
    home = file.resolve().parent
    return home.parent if home.name == _ROBOTS else home


def carried(robot: RobotModel, root: Path, file: Path) -> CarriedRobot:
    """Return a robot with its meshes in the folder `meshes` beside a file; in its own project they stay.

    Meshes that are in that folder already stay, too.

    Args:
        robot: its mesh paths count from `root`.
        root: folder.
        file: new file of the robot, in a project; its format determines from where the new paths count.
    """
    project = project_of_robot(file)
    files = dict.fromkeys(mesh.file for mesh in _meshes(robot))
    if root.resolve() == project:
        return CarriedRobot(_with_paths(robot, _named({one: one for one in files}, file)), {})
    beside = file.resolve().parent.relative_to(project).as_posix()
    stem = plain_name(file)
    folder = f"meshes/{stem}" if beside == "." else f"{beside}/meshes/{stem}"
    paths = {one: f"{folder}/{inside}" for one in files if (inside := _inside(root / one, project / folder))}
    taken = {path.lower() for path in paths.values()}
    copied = [one for one in files if one not in paths]
    for one in copied:
        paths[one] = _unused(folder, PurePosixPath(one), taken)
    copies = {paths[one]: root / one for one in copied}
    return CarriedRobot(_with_paths(robot, _named(paths, file)), copies)


def _inside(place: Path, folder: Path) -> str:
    """Return the path of a file from a folder on; empty where it is not in there."""
    place = Path(os.path.realpath(place))
    return place.relative_to(folder).as_posix() if place.is_relative_to(folder) else ""


def _named(paths: Mapping[str, str], file: Path) -> Mapping[str, str]:
    """Return paths that count from the project folder as the format of a file counts them."""
    if file.suffix.lower() not in MESHES_FROM_FILE:
        return paths
    home, project = file.resolve().parent, project_of_robot(file)
    return {old: Path(os.path.relpath(project / path, home)).as_posix() for old, path in paths.items()}


def plain_name(file: Path) -> str:
    """Return the name of a robot after its file: `ur5e` for `ur5e.urdf.xacro`."""
    return re.sub(r"[^\w-]", "_", file.name.partition(".")[0]) or "robot"


def _meshes(robot: RobotModel) -> list[Mesh]:
    shapes = (*robot.base_shapes, *(shape for link in robot.links for shape in link.shapes))
    return [shape.solid for shape in shapes if isinstance(shape.solid, Mesh)]


def _unused(folder: str, path: PurePosixPath, taken: set[str]) -> str:
    """Return the path of a mesh file in a folder, with a number where another one has it."""
    found, number = f"{folder}/{path.name}", 1
    while found.lower() in taken:
        number += 1
        found = f"{folder}/{path.stem}_{number}{path.suffix}"
    taken.add(found.lower())
    return found


def _with_paths(robot: RobotModel, paths: Mapping[str, str]) -> RobotModel:
    return replace(
        robot,
        base_shapes=_moved(robot.base_shapes, paths),
        links=tuple(replace(link, shapes=_moved(link.shapes, paths)) for link in robot.links),
    )


def _moved(shapes: tuple[Shape, ...], paths: Mapping[str, str]) -> tuple[Shape, ...]:
    return tuple(
        replace(shape, solid=replace(shape.solid, file=paths[shape.solid.file]))
        if isinstance(shape.solid, Mesh)
        else shape
        for shape in shapes
    )
