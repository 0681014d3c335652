"""What a reader of robot files gives: the robot, if it could be read, and what was found."""

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.model.robot import RobotModel


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
