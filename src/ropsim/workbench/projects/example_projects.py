"""New projects, made from an example or for a robot."""

import shutil
import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path

from ropsim.core import did_you_mean, retried, there_are
from ropsim.model import RobotSource
from ropsim.userfiles import STARTER, example_names, examples_folder
from ropsim.workbench.project_diagnostics import NO_EXAMPLE, PLACE_TAKEN
from ropsim.workbench.projects.project import ProjectError
from ropsim.workbench.projects.project_name import name_from_folder, name_project

_LEFT_OUT = shutil.ignore_patterns("out", "__pycache__")


def new_project(place: str | Path, example: str = STARTER) -> Path:
    """Make a project folder from an example and return it; all files appear at once or none does.

    The project has the name of its folder.

    Raises:
        ProjectError: unknown example, or the place is taken or cannot be written.
    """
    if example not in example_names():
        message = f"there is no example `{example}`, {there_are(example_names())}"
        raise ProjectError(NO_EXAMPLE.at(None, message, hint=did_you_mean(example, example_names())))

    def fill(folder: Path, name: str) -> None:
        shutil.copytree(examples_folder() / example, folder, ignore=_LEFT_OUT)
        name_project(folder, name)

    return _made(place, fill)


def new_robot_project(place: str | Path, robot: str | RobotSource) -> Path:
    """Make a project folder for a robot and return it; all files appear at once or none does.

    Its program moves the robot along a way that it can go. The project has the name of its folder.

    Args:
        place: of the folder.
        robot: name of a built-in robot, or the path of a robot file, which is copied into the project; a
            `RobotSource` adds tip, packages and arguments.

    Raises:
        UnknownRobotError: X860, no built-in robot has this name.
        RobotFileError: the file cannot be read, or an error in it forbids a robot.
        ProjectError: the place is taken or cannot be written.
    """
    from ropsim.workbench.projects.robot_project import fill_robot_project

    source = robot if isinstance(robot, RobotSource) else RobotSource(robot)
    return _made(place, lambda folder, name: fill_robot_project(folder, name, source))


def _made(place: str | Path, fill: Callable[[Path, str], None]) -> Path:
    """Return a new folder that a function has filled.

    Args:
        place: of the folder.
        fill: writes the files of a project of a name into a folder that is not there yet.

    Raises:
        ProjectError: the place is taken or cannot be written.
    """
    target = Path(place)
    try:
        if target.exists() and (not target.is_dir() or any(target.iterdir())):
            raise ProjectError(PLACE_TAKEN.at(None, f"`{place}` exists and is not an empty folder"))
        target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=target.parent, prefix=".ropsim-") as work:
            made = Path(work) / "project"
            fill(made, name_from_folder(target.resolve().name))
            _move(made, target)
    except OSError as error:
        message = f"`{place}` cannot be made: {error.strerror or error}"
        raise ProjectError(PLACE_TAKEN.at(None, message)) from error
    return target


def _move(made: Path, target: Path) -> None:
    """Put a folder at its place; into an empty folder its entries move, `cell.toml` as the last one."""
    if not target.exists():
        retried(partial(made.replace, target))
        return
    for entry in sorted(made.iterdir(), key=lambda entry: entry.name == "cell.toml"):
        retried(partial(entry.replace, target / entry.name))
