"""What a reader of robot files gives, and what a writer of them gives."""

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.model.robots.robot import RobotModel


@frozen_dataclass
class ReadRobot:
    """A robot read from a file.

    Attributes:
        robot: the model; nothing where an error forbids one.
        findings: what was found, in the order of the file: errors, doubtful numbers, and what the file says
            and the model cannot hold (losses, one code of their own).
    """

    robot: RobotModel | None
    findings: tuple[Diagnostic, ...]


@frozen_dataclass
class WrittenRobot:
    """A robot written in a format of files.

    Attributes:
        text: of the file, in its one canonical form.
        losses: what the model holds and the format cannot say, in the order of the model.
    """

    text: str
    losses: tuple[Diagnostic, ...]
