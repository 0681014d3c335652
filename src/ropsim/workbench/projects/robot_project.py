"""A new project for a robot: its cell, and a first program that has been run without dynamics."""

from itertools import islice
from pathlib import Path

from ropsim.cellfile import POINTER, is_foreign_file, new_cell, written_coordinates
from ropsim.core import Diagnostic, read_bytes
from ropsim.flow import Fidelity
from ropsim.model import Mesh, RobotModel, RobotSource, Shape
from ropsim.robots import swings
from ropsim.simulation import RunOptions
from ropsim.workbench.projects.first_way import FirstWay, first_ways, turning
from ropsim.workbench.projects.opening import open_project
from ropsim.workbench.robots.carried_meshes import carried, plain_name
from ropsim.workbench.robots.completed_robot import completed_robot
from ropsim.workbench.robots.named_robot import NamedRobot, RobotFileError, find_robot, written_robot

_HEAD = "program {name}\nunits mm, deg, s\n\n"
_CAREFUL = "# The arm swings: faster, its joints would go beyond their limits.\nset speed 70 %\n\n"


_MEETING = """\
# Every way that was tried has a collision of the arm with itself, this one: {}.
# Bodies count as convex, so that meshes with hollows can meet where the arm does not.

"""
_MOST_WAYS = 8


def fill_robot_project(folder: Path, name: str, source: RobotSource) -> None:
    """Write a project into a folder that is not there yet.

    Args:
        folder: of the project.
        name: of its cell and its program.
        source: path of a robot file, or the name of a built-in robot. A file of our own formats is copied
            with its meshes; a robot in another format becomes a NIROX file, as by `ropsim robot import`, with
            estimated rotors, gears and friction where it has masses and torques alone.

    Raises:
        UnknownRobotError: X860, no built-in robot has this name.
        RobotFileError: the file cannot be read, or an error in it forbids a robot.
        OSError: a file cannot be written.
    """
    found = find_robot(source)
    if found.robot is None:
        raise RobotFileError(next(one for one in found.findings if one.is_error))
    model, named = found.robot, source.path
    if found.text:
        foreign = is_foreign_file(source.path)
        take, model = (_imported, completed_robot(model)) if foreign else (_copied, model)
        named = take(folder, Path(source.path), found, model)
    (folder / "programs").mkdir(parents=True)
    head = _HEAD.format(name=name) + (_CAREFUL if swings(model) else "")
    meeting: tuple[FirstWay, Diagnostic] | None = None
    for way in (*islice(first_ways(model, POINTER), _MOST_WAYS), turning(model)):
        _write_way(folder, new_cell(name, named, way.corners), head + _statements(model, way))
        project = open_project(folder)
        recording = project.simulate(options=RunOptions(Fidelity.KINEMATIC))
        if not recording.ok:
            continue
        collision = next((one for one in project.collisions(recording).findings if one.is_error), None)
        if collision is None:
            return
        meeting = meeting or (way, collision)
    if meeting is not None:
        way, collision = meeting
        remark = _MEETING.format(collision.message.partition(", line")[0])
        _write_way(folder, new_cell(name, named, way.corners), head + remark + _statements(model, way))


def _write_way(folder: Path, cell: str, program: str) -> None:
    (folder / "cell.toml").write_text(cell, "utf-8")
    (folder / "programs" / "main.task").write_text(program, "utf-8")


def _imported(folder: Path, file: Path, found: NamedRobot, model: RobotModel) -> str:
    """Write a robot of another format as NIROX, with its meshes; return its path in the project."""
    inside = f"robots/{plain_name(file)}.stp"
    moved = carried(model, found.mesh_root, folder / inside)
    _write(folder / inside, written_robot(moved.robot, inside).text.encode("utf-8"))
    moved.copy(folder)
    return inside


def _copied(folder: Path, file: Path, found: NamedRobot, model: RobotModel) -> str:
    """Copy a robot file and the meshes that are there into a project; return its path in the project."""
    inside = f"robots/{file.name}"
    root = found.mesh_root
    for mesh in sorted({solid.file for solid in map(_solid, _shapes(model)) if isinstance(solid, Mesh)}):
        source = (root / mesh).resolve()
        if source.is_relative_to(root) and source.is_file():
            _write(folder / mesh, read_bytes(source))
    _write(folder / inside, read_bytes(file))
    return inside


def _write(path: Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def _shapes(model: RobotModel) -> tuple[Shape, ...]:
    return (*model.base_shapes, *(shape for link in model.links for shape in link.shapes))


def _solid(shape: Shape) -> object:
    return shape.solid


def _statements(model: RobotModel, way: FirstWay) -> str:
    lines = [f"mov joints({written_coordinates(model, q)})" for q in way.turns]
    names = [f"corner_{number}" for number in range(1, len(way.corners) + 1)]
    if names:
        lines += [
            f"{'lin' if lines else 'mov'} {names[0]}",
            *(f"lin {one}" for one in (*names[1:], names[0])),
        ]
    return "\n".join([*lines, "mov home"]) + "\n"
