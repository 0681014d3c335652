"""The formats of robot files: a new one is a line of this table; it is loaded when its first file is met."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from enum import StrEnum
from importlib import import_module
from types import MappingProxyType
from typing import Any

from ropsim.core import SourceText, frozen_dataclass
from ropsim.model import PlaceOf, ReadRobot, RobotModel, WrittenRobot
from ropsim.workbench.robots.read_request import ReadRequest, unasked_packages, unused_request


class StepForm(StrEnum):
    """Form of a robot in a STEP file.

    Attributes:
        NIROX: everything that the model holds.
        AP242: the mechanism alone, in entities of AP242 only.
    """

    NIROX = "nirox"
    AP242 = "ap242"


@frozen_dataclass
class RobotFormat:
    """How files of one ending are read and written: functions of one package, by their names.

    Attributes:
        package: front that has them.
        reader: a text to a robot; empty where there is none.
        writer: a robot to a text; empty where there is none. If the reader keeps other data of a file, the
            writer also takes them.
        finder: where the numbers of the robot stand in a text that was read; empty if unknown.
    """

    package: str
    reader: str = ""
    writer: str = ""
    finder: str = ""

    def read(self, source: SourceText, request: ReadRequest) -> ReadRobot:
        """Return the robot of a text; a finding where a request has no meaning for the format."""
        found: ReadRobot = self._function(self.reader)(source)
        unused = request.words
        return (
            replace(found, robot=None, findings=(unused_request(source.name, unused),)) if unused else found
        )

    def write(self, robot: RobotModel) -> WrittenRobot:
        """Return the text of a robot."""
        written: WrittenRobot = self._function(self.writer)(robot)
        return written

    def write_again(self, robot: RobotModel, read: ReadRobot) -> WrittenRobot:
        """Return the text of a robot read from a file, with the other data of the file, or their loss."""
        from ropsim.nirox import ReadNirox

        if not isinstance(read, ReadNirox):
            return self.write(robot)
        if self is _NIROX:
            again: WrittenRobot = self._function(self.writer)(robot, read.further)
            return again
        from ropsim.exchange import kept_lost

        written = self.write(robot)
        return replace(written, losses=(*written.losses, *kept_lost(read.further)))

    def places(self, source: SourceText) -> PlaceOf | None:
        """Return where the numbers of the robot stand in a text."""
        if not self.finder:
            return None
        found: PlaceOf = self._function(self.finder)(source)
        return found

    def _function(self, name: str) -> Callable[..., Any]:
        found: Callable[..., Any] = getattr(import_module(self.package), name)
        return found


class ForeignFormat(RobotFormat):
    """A format of others: a link of the file carries the tool, and the file may need files around it."""

    def read(self, source: SourceText, request: ReadRequest) -> ReadRobot:
        """Return the robot of a text, with the files around it."""
        options = request.options
        found: ReadRobot = self._function(self.reader)(source, options)
        unused = unasked_packages(source.name, options.folder.packages)
        if not unused or (found.robot is None and not any(one.data.get("near") for one in unused)):
            return found  # reading ended before all packages were asked for
        return replace(found, robot=None, findings=(*unused, *found.findings))


_EXCHANGE = "ropsim.exchange"
_NIROX = RobotFormat("ropsim.nirox", "read_nirox", "write_nirox", "nirox_places")
_AP242 = RobotFormat(_EXCHANGE, writer="write_ap242")
_FORMATS = {
    ".toml": RobotFormat("ropsim.robotfile", "read_robot_file", "write_robot_file", "robot_file_places"),
    ".urdf": ForeignFormat(_EXCHANGE, "read_urdf", "write_urdf"),
    ".xacro": ForeignFormat(_EXCHANGE, "read_urdf"),
    ".xml": ForeignFormat(_EXCHANGE, "read_mjcf", "write_mjcf"),
    ".stp": _NIROX,
    ".step": _NIROX,
    ".sdf": RobotFormat(_EXCHANGE, writer="write_sdf"),
}

ROBOT_FORMATS: Mapping[str, RobotFormat] = MappingProxyType(
    {ending: one for ending, one in _FORMATS.items() if one.reader}
)
"""Formats for reading, by the ending of the file name in small letters."""

WRITERS: Mapping[str, RobotFormat] = MappingProxyType(
    {ending: one for ending, one in _FORMATS.items() if one.writer}
)
"""Formats for writing, by the ending; not every one can be read."""

MESHES_FROM_FILE = tuple(ending for ending, one in _FORMATS.items() if one.package == _EXCHANGE)
"""Endings of the formats in which paths of meshes count from the folder of the file, not of the project."""

STEP_ENDINGS = tuple(ending for ending, one in _FORMATS.items() if one is _NIROX)
STEP_WRITERS: Mapping[StepForm, RobotFormat] = MappingProxyType(
    {StepForm.NIROX: _NIROX, StepForm.AP242: _AP242}
)
"""Writers of STEP files, by form."""
