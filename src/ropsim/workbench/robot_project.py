"""A new project for a robot: its cell, and a first program that has been run without dynamics."""

import math
from pathlib import Path

import numpy as np

from ropsim.flow import Fidelity
from ropsim.model import JointType, Mesh, RobotModel, Shape
from ropsim.simulation import RunOptions
from ropsim.spatial import Array, Pose, quaternion
from ropsim.workbench.first_way import FirstWay, first_way, turning
from ropsim.workbench.named_robot import find_robot, load_robot
from ropsim.workbench.opening import open_project

X_MT = Pose(np.array([0.0, 0.0, 0.1]))
"""The tool of a new project: a point 100 mm in front of the mechanical interface."""

_CELL = """\
# A cell with one robot. Lengths in millimetres, angles in degrees, masses in kilograms.
# Every key is described in docs/reference/cell-file.md.

[cell]
name = "{name}"

[robot]
model = "{model}"
tool = "pointer"

# Put your tool here: its tip, its mass and its centre of mass in the mechanical interface frame.
[tools.pointer]
position = [0, 0, 100]
"""
_PLACES = "\n# Places that the robot reaches along straight lines; the tool points {how}.\n"
_HEAD = "program {name}\nunits mm, deg, s\n\n"


def fill_robot_project(folder: Path, name: str, robot: str) -> None:
    """Write a project into a folder that is not there yet.

    Args:
        folder: of the project.
        name: of its cell and its program.
        robot: name of a built-in robot, or the path of a robot file, which is copied with its meshes.

    Raises:
        UnknownRobotError: X860, no built-in robot has this name.
        RobotFileError: the file cannot be read, or an error in it forbids a robot.
        OSError: a file cannot be written.
    """
    model = load_robot(robot)
    named = _copied(folder, Path(robot), model) if find_robot(robot).text else robot
    (folder / "programs").mkdir(parents=True)
    for way in (first_way(model, X_MT), turning(model)):
        cell = _CELL.format(name=name, model=named) + _locations(way)
        (folder / "cell.toml").write_text(cell, "utf-8")
        program = _HEAD.format(name=name) + _statements(model, way)
        (folder / "programs" / "main.task").write_text(program, "utf-8")
        if open_project(folder).simulate(options=RunOptions(Fidelity.KINEMATIC)).ok:
            return


def _copied(folder: Path, file: Path, model: RobotModel) -> str:
    """Copy a robot file and the meshes that are there into a project; return its path in the project."""
    inside = f"robots/{file.name}"
    home = file.resolve().parent
    root = home.parent if home.name == "robots" else home
    for mesh in sorted({solid.file for solid in map(_solid, _shapes(model)) if isinstance(solid, Mesh)}):
        source = (root / mesh).resolve()
        if source.is_relative_to(root) and source.is_file():
            _write(folder / mesh, source.read_bytes())
    _write(folder / inside, file.read_bytes())
    return inside


def _write(path: Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


def _shapes(model: RobotModel) -> tuple[Shape, ...]:
    return (*model.base_shapes, *(shape for link in model.links for shape in link.shapes))


def _solid(shape: Shape) -> object:
    return shape.solid


def _locations(way: FirstWay) -> str:
    """Return the corners of a way as locations; a tool that points down needs no orientation."""
    if not way.corners:
        return ""
    turn = _turn(way.corners[0])
    text = _PLACES.format(how="along the same direction at all of them" if turn else "straight down")
    for number, corner in enumerate(way.corners, start=1):
        x, y, z = (_number(1e3 * value, 3) for value in corner.position.tolist())
        text += f"\n[locations.corner_{number}]\nposition = [{x}, {y}, {z}]\n{turn}"
    return text


def _turn(pose: Pose) -> str:
    w, x, y, z = (float(one) for one in pose.orientation)
    if abs(x) == 1.0:
        return ""
    yaw, pitch, roll = (math.degrees(angle) for angle in quaternion.to_zyx((w, x, y, z)))
    return f"rpy = [{', '.join(_number(angle, 9) for angle in (roll, pitch, yaw))}]\n"


def _statements(model: RobotModel, way: FirstWay) -> str:
    lines = [f"mov joints({_coordinates(model, q)})" for q in way.turns]
    names = [f"corner_{number}" for number in range(1, len(way.corners) + 1)]
    if names:
        lines += [
            f"{'lin' if lines else 'mov'} {names[0]}",
            *(f"lin {one}" for one in (*names[1:], names[0])),
        ]
    return "\n".join([*lines, "mov home"]) + "\n"


def _coordinates(model: RobotModel, q: Array) -> str:
    scales = [1e3 if joint.measure is JointType.PRISMATIC else 180.0 / math.pi for joint in model.axis_joints]
    return ", ".join(_number(scale * value, 1) for scale, value in zip(scales, q.tolist(), strict=True))


def _number(value: float, digits: int) -> str:
    """Return a number without zeros behind it."""
    return f"{round(value, digits) + 0.0:.{digits}f}".rstrip("0").rstrip(".")
