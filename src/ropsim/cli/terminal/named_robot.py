"""The robot of a command: built in, or from a file whose findings are printed; and the file it becomes."""

import argparse
from collections.abc import Callable
from pathlib import Path

from ropsim.cli.terminal.output import Output, cannot_write, is_input
from ropsim.core import Diagnostic, replace_file
from ropsim.model import RobotModel, RobotSource
from ropsim.records import diagnostic_document
from ropsim.workbench import CarriedRobot, NamedRobot, RobotFileError, find_robot, project_of_robot


def named_robot(options: argparse.Namespace, output: Output) -> RobotModel | None:
    """Return the robot of the argument `name`; None where its file is wrong, which has been said.

    Raises:
        UnknownRobotError: X860, no built-in robot has this name.
        RobotFileError: the file cannot be read.
    """
    return asked_robot(options, output).robot


def _nothing(_finding: Diagnostic) -> bool:
    return False


def asked_robot(
    options: argparse.Namespace, output: Output, is_mended: Callable[[Diagnostic], bool] = _nothing
) -> NamedRobot:
    """Return the robot of the argument `name` with its other data; raises as `named_robot` does.

    Args:
        options: with the name, tip, packages and arguments.
        output: to which findings are printed.
        is_mended: whether the command mends what a finding says, so that it is not printed.
    """
    found = find_robot(requested(options, options.name))
    say_tip(found, output)
    findings = tuple(one for one in found.findings if not is_mended(one))
    output.findings(findings, {found.text.name: found.text} if found.text else {})
    if found.robot is None:
        output.document({"ok": False, **diagnostic_document(found.findings)})
    return found


def tip_name(found: NamedRobot) -> str | None:
    """Return the link that carries the tool; None where a robot names its interface itself."""
    return found.read.tip.name if found.read and found.read.tip else None


def say_tip(found: NamedRobot, output: Output) -> None:
    """Print which link carries the tool, where a file does not say that itself."""
    if tip := found.read.tip if found.read and found.robot else None:
        output.text(f"the tool is carried by `{tip.name}`: {tip.reason} (another one: --tip LINK)")


def requested(options: argparse.Namespace, name: str) -> RobotSource:
    """Return the robot of a command with tip, packages and arguments."""
    return RobotSource(name, options.tip, tuple(options.package), tuple(options.arg))


def write_robot_file(file: str, text: str, moved: CarriedRobot, asked: NamedRobot) -> None:
    """Write a robot file, and copy the meshes of the robot into its project.

    Args:
        file: path of the file; its folder is made.
        text: of the file.
        moved: the robot with its meshes at their new places.
        asked: the robot as it was read; its own files are not replaced.

    Raises:
        RobotFileError: X847, a file cannot be written.
    """
    place = Path(file)
    if asked.is_read_from(place):
        raise RobotFileError(is_input(file))
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        moved.copy(project_of_robot(place))
    except OSError as error:
        raise RobotFileError(cannot_write(file, _of_mesh(error, file))) from error
    try:
        replace_file(place, text.encode("utf-8"))
    except OSError as error:
        raise RobotFileError(cannot_write(file, error)) from error


def _of_mesh(error: OSError, file: str) -> OSError:
    """Return an error whose words name the mesh that could not be copied, if it is about one."""
    named = str(error.filename or file)
    return error if named == file else OSError(error.errno, f"its mesh `{named}`: {error.strerror or error}")
