"""The files of robots that a project names: read from inside of its folder, by the format of their ending."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import Path, PurePosixPath
from typing import TypeAlias

from ropsim.core import (
    Diagnostic,
    LeadsOutError,
    SourceText,
    did_you_mean,
    frozen_dataclass,
    outside_project,
    stated_inside,
)
from ropsim.model import REQUEST, ReadRobot, RobotSource
from ropsim.userfiles import UNREADABLE, missing_file
from ropsim.workbench.project_diagnostics import UNKNOWN_ROBOT_FORMAT
from ropsim.workbench.robots.kept_readings import KeptReadings
from ropsim.workbench.robots.read_request import TEXT_ALONE, ReadRequest
from ropsim.workbench.robots.robot_formats import ROBOT_FORMATS, STEP_ENDINGS, WRITERS, StepForm

Reading: TypeAlias = tuple[SourceText | None, tuple[Diagnostic, ...]]
"""Result of reading a file: its text, or why there is none."""

TextOf: TypeAlias = Callable[[str], Reading]
"""Reads a file of a project by its path inside."""


@frozen_dataclass
class RobotFile:
    """A file of a robot.

    Attributes:
        text: its content; None where it cannot be read.
        read: content; findings without a place report why it cannot be read.
    """

    text: SourceText | None
    read: ReadRobot


def read_robot_files(
    folder: Path, sources: Iterable[RobotSource], text_of: TextOf
) -> Mapping[RobotSource, RobotFile]:
    """Return the robot files of a project; errors are findings.

    Args:
        folder: of the project.
        sources: files inside the folder, as in its cell file.
        text_of: reads one of them.
    """
    return {source: _read(folder, source, text_of) for source in sources}


def robots_read(files: Mapping[RobotSource, RobotFile]) -> Mapping[RobotSource, ReadRobot]:
    """Return the robots read from files."""
    return {source: one.read for source, one in files.items()}


def read_robot(text: SourceText, request: ReadRequest = TEXT_ALONE) -> ReadRobot:
    """Return the robot that a text describes, in the format of the ending of its name.

    Args:
        text: of the file.
        request: tip, arguments, and where files around it are.
    """
    format_ = ROBOT_FORMATS.get(PurePosixPath(text.name).suffix.lower())
    if format_ is None:
        return ReadRobot(None, (unknown_format(text.name),))
    return _READINGS.of(text, request, format_.read)


_READINGS = KeptReadings()


def unknown_format(name: str, place: Path | None = None) -> Diagnostic:
    """Return the finding that files of this name hold no robot.

    Args:
        name: the given name.
        place: where the file would be; robot files in its folder are candidates for near names.
    """
    message = f"`{name[:200]}` is no file of a robot, these end with {_listed(ROBOT_FORMATS)}"
    hint = "`ropsim robot list` names the built-in robots"
    if place is not None and place.parent.is_dir():
        beside = [one.name for one in place.parent.iterdir() if one.suffix.lower() in ROBOT_FORMATS]
        hint = did_you_mean(place.name, beside) or hint
    return UNKNOWN_ROBOT_FORMAT.at(None, message, hint=hint)


def unwritten_format(name: str) -> Diagnostic:
    """Return the finding that robots are not written into files of this name."""
    message = f"robots are not written into `{name[:200]}`, but into files that end with {_listed(WRITERS)}"
    return UNKNOWN_ROBOT_FORMAT.at(None, message)


def no_step_file(name: str, form: StepForm) -> Diagnostic:
    """Return the finding that a form of STEP files was requested in a file of another format."""
    message = f"`{name[:200]}` is no file for the form `{form}`, these end with {_listed(STEP_ENDINGS)}"
    return UNKNOWN_ROBOT_FORMAT.at(None, message)


def _listed(endings: Iterable[str]) -> str:
    return ", ".join(f"`{ending}`" for ending in endings)


def _read(folder: Path, source: RobotSource, text_of: TextOf) -> RobotFile:
    refused = _refusal(folder, source.path)
    if refused is not None:
        return RobotFile(None, ReadRobot(None, (refused,)))
    text, findings = text_of(source.path)
    if text is None:
        return RobotFile(None, ReadRobot(None, findings))
    absent = tuple(
        replace(missing_file(folder / place, place), data={REQUEST: ("package", name)})
        for name, place in source.packages
        if not (folder / place).is_dir()
    )
    if absent:
        return RobotFile(text, ReadRobot(None, absent))
    return RobotFile(text, read_robot(text, ReadRequest(source, folder)))


def _refusal(folder: Path, path: str) -> Diagnostic | None:
    """Return why a file is not opened; None where it may be read."""
    try:
        stated_inside(folder, path)
    except LeadsOutError as error:
        return outside_project(path, error)
    except OSError as error:  # odd characters
        return UNREADABLE.at(None, f"`{path[:200]}` cannot be opened: {error.strerror}")
    if PurePosixPath(path).suffix.lower() not in ROBOT_FORMATS:
        return unknown_format(path, folder / path)
    return None
