"""Results of readers and writers of robot files."""

from pathlib import Path

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.model.robots.robot import RobotModel


@frozen_dataclass
class RobotSource:
    """A robot file, and what is requested of it.

    Attributes:
        path: of the file.
        tip: name of the link that carries the tool; empty for the one that is recognised.
        packages: folders of packages by name, for files that name others.
        arguments: of a xacro file, by name.
    """

    path: str
    tip: str = ""
    packages: tuple[tuple[str, str], ...] = ()
    arguments: tuple[tuple[str, str], ...] = ()


REQUEST = "request"
"""Key of the data of a finding on what is requested of a robot file: the path of the key of the request in a
cell file, such as `("arg", "hand")`; the finding then stands there, not in the robot file."""


@frozen_dataclass
class Tip:
    """The link of a robot file that carries the tool.

    Attributes:
        name: of the link or frame.
        reason: why it was chosen, a clause such as `its name is usual`.
    """

    name: str
    reason: str


@frozen_dataclass
class ReadRobot:
    """A robot read from a file.

    Attributes:
        robot: the model; nothing where an error forbids one.
        findings: findings in the order of the file: errors, doubtful numbers, and data of the file that the
            model cannot hold (losses, with a separate code).
        tip: link that carries the tool; None where the format names the interface, or no robot was read.
        files: further files and folders that reading depends on, present or missing.
    """

    robot: RobotModel | None
    findings: tuple[Diagnostic, ...]
    tip: Tip | None = None
    files: tuple[Path, ...] = ()


@frozen_dataclass
class WrittenRobot:
    """A robot written in a format of files.

    Attributes:
        text: of the file, in its one canonical form.
        losses: data of the model that the format cannot represent, in the order of the model.
    """

    text: str
    losses: tuple[Diagnostic, ...]
