"""Robots by name: a built-in one, or the path of a robot file."""

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

from ropsim import robots
from ropsim.cellfile import is_foreign_file, is_robot_file
from ropsim.core import Diagnostic, RopsimError, SourceText, frozen_dataclass
from ropsim.model import PlaceOf, ReadRobot, RobotModel, RobotSource, WrittenRobot, nowhere
from ropsim.userfiles import missing_file, read_text_file
from ropsim.workbench.robots.carried_meshes import project_of_robot
from ropsim.workbench.robots.read_request import ReadRequest, unused_request
from ropsim.workbench.robots.robot_files import no_step_file, read_robot, unknown_format, unwritten_format
from ropsim.workbench.robots.robot_formats import ROBOT_FORMATS, STEP_ENDINGS, STEP_WRITERS, WRITERS, StepForm

NOTHING: Mapping[str, str] = MappingProxyType({})


class RobotFileError(RopsimError):
    """A robot file from which no robot can be made; carries the first error in it."""


@frozen_dataclass
class NamedRobot:
    """A robot requested by its name or file.

    Attributes:
        robot: the model; None where its file is wrong.
        findings: of reading the file.
        text: content of the file; None of a built-in robot.
        read: everything that was read from it; None of a built-in robot.
    """

    robot: RobotModel | None
    findings: tuple[Diagnostic, ...] = ()
    text: SourceText | None = None
    read: ReadRobot | None = None

    @property
    def mesh_root(self) -> Path:
        """Return the folder from which the paths of its meshes count."""
        file = Path(self.text.name if self.text else ".")
        if is_foreign_file(file.name):
            return Path(file.absolute().anchor)
        return project_of_robot(file)

    def is_read_from(self, place: Path) -> bool:
        """Return whether a path leads to the file of the robot, or to one that this includes."""
        used = (Path(self.text.name), *(self.read.files if self.read else ())) if self.text else ()
        try:
            return place.exists() and any(one.exists() and place.samefile(one) for one in used)
        except OSError:  # links that go round
            return False

    @property
    def place_of(self) -> PlaceOf:
        """Return where the numbers of the robot stand in its file."""
        if self.text is None:
            return nowhere
        format_ = ROBOT_FORMATS.get(Path(self.text.name).suffix.lower())
        return (format_.places(self.text) if format_ else None) or nowhere


def find_robot(name: str | Path | RobotSource) -> NamedRobot:
    """Return a robot, or the errors in its file.

    Args:
        name: of a built-in robot, or the path of a file, which has a dot or a slash; a `RobotSource` adds
            tip, packages and arguments.

    Raises:
        UnknownRobotError: X860, no built-in robot has this name.
        RobotFileError: the file does not exist, cannot be read, or has an unknown ending.
    """
    source = name if isinstance(name, RobotSource) else RobotSource(str(name))
    request = ReadRequest(source)
    if not is_robot_file(source.path):
        if request.words:
            raise RobotFileError(unused_request(source.path, request.words))
        return NamedRobot(robots.load(source.path))
    for _, folder in source.packages:
        if not Path(folder).is_dir():
            raise RobotFileError(missing_file(Path(folder), folder))
    path = Path(source.path)
    if path.suffix.lower() not in ROBOT_FORMATS:
        raise RobotFileError(unknown_format(source.path, path))
    text, findings = read_text_file(path, source.path)
    if text is None:
        raise RobotFileError(findings[0])
    read = read_robot(text, request)
    return NamedRobot(read.robot, read.findings, text, read)


def load_robot(
    name: str | Path,
    *,
    tip: str = "",
    packages: Mapping[str, str] = NOTHING,
    arguments: Mapping[str, str] = NOTHING,
) -> RobotModel:
    """Return a robot by its name, or the path of its file.

    Args:
        name: of a built-in robot, or the path of a file, which has a dot or a slash.
        tip: name of the link that carries the tool, for URDF, xacro and MJCF; empty for the recognised one.
        packages: folders of packages by name that are not found around the file.
        arguments: of a xacro file, by name.

    Raises:
        UnknownRobotError: X860, no built-in robot has this name.
        RobotFileError: the file cannot be read, or an error in it forbids a robot.
    """
    found = find_robot(RobotSource(str(name), tip, tuple(packages.items()), tuple(arguments.items())))
    if found.robot is None:
        raise RobotFileError(next(one for one in found.findings if one.is_error))
    return found.robot


def written_robot(
    robot: RobotModel, name: str | Path, read: ReadRobot | None = None, form: StepForm = StepForm.NIROX
) -> WrittenRobot:
    """Return a robot as the text of a file, and its losses.

    Args:
        robot: to be written.
        name: of the file, whose ending says in which format.
        read: its source; other data of the source are written again, if the format supports them.
        form: form of a STEP file.

    Raises:
        RobotFileError: X911, robots are not written into files of this ending, or not in this form.
    """
    ending = Path(name).suffix.lower()
    if form is not StepForm.NIROX and ending not in STEP_ENDINGS:
        raise RobotFileError(no_step_file(str(name), form))
    if ending not in WRITERS:
        raise RobotFileError(unwritten_format(str(name)))
    format_ = STEP_WRITERS[form] if ending in STEP_ENDINGS else WRITERS[ending]
    return format_.write(robot) if read is None else format_.write_again(robot, read)


def built_in_robots() -> tuple[str, ...]:
    """Return the names of the built-in robots."""
    return robots.names()


def robots_in(folder: Path) -> tuple[Path, ...]:
    """Return the robot files in the folder `robots` of a project, by name."""
    place = folder / "robots"
    if not place.is_dir():
        return ()
    return tuple(sorted(path for path in place.iterdir() if path.suffix.lower() in ROBOT_FORMATS))
