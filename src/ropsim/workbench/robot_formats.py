"""The formats of robot files: a new one is an entry here."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from ropsim.core import SourceText, frozen_dataclass
from ropsim.model import PlaceOf, ReadRobot
from ropsim.robotfile import read_robot_file, robot_file_places


@frozen_dataclass
class RobotFormat:
    """How files of one ending are read.

    Attributes:
        read: a text to a robot.
        places: where the numbers of the robot stand in a text that could be read; None where nobody can tell.
    """

    read: Callable[[SourceText], ReadRobot]
    places: Callable[[SourceText], PlaceOf] | None = None


ROBOT_FORMATS: Mapping[str, RobotFormat] = MappingProxyType(
    {
        ".toml": RobotFormat(read_robot_file, robot_file_places),
    }
)
"""By the ending of the file name, in small letters."""
