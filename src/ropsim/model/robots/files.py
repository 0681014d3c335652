"""Results of readers and writers of robot files."""

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.model.robots.robot import RobotModel


@frozen_dataclass
class ReadRobot:
    """A robot read from a file.

    Attributes:
        robot: the model; nothing where an error forbids one.
        findings: findings in the order of the file: errors, doubtful numbers, and data of the file that the
            model cannot hold (losses, with a separate code).
    """

    robot: RobotModel | None
    findings: tuple[Diagnostic, ...]


@frozen_dataclass
class WrittenRobot:
    """A robot written in a format of files.

    Attributes:
        text: of the file, in its one canonical form.
        losses: data of the model that the format cannot represent, in the order of the model.
    """

    text: str
    losses: tuple[Diagnostic, ...]
