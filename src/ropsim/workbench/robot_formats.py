"""The formats of robot files: a new one is an entry here."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from ropsim.core import SourceText, frozen_dataclass
from ropsim.exchange import read_mjcf, read_nirox, read_urdf, write_mjcf, write_nirox, write_sdf, write_urdf
from ropsim.model import PlaceOf, ReadRobot, RobotModel, WrittenRobot
from ropsim.robotfile import read_robot_file, robot_file_places, write_robot_file


@frozen_dataclass
class RobotFormat:
    """How files of one ending are read and written.

    Attributes:
        read: a text to a robot.
        places: where the numbers of the robot stand in a text that could be read; None where nobody can tell.
        write: a robot to a text; None where there is no writer.
        write_again: the same of a robot that was read from a file, with what that said beside it; None where
            nothing is kept beside robots.
    """

    read: Callable[[SourceText], ReadRobot]
    places: Callable[[SourceText], PlaceOf] | None = None
    write: Callable[[RobotModel], WrittenRobot] | None = None
    write_again: Callable[[RobotModel, ReadRobot], WrittenRobot] | None = None


def _nirox_again(robot: RobotModel, read: ReadRobot) -> WrittenRobot:
    from ropsim.nirox import ReadNirox

    return write_nirox(robot, read.beside) if isinstance(read, ReadNirox) else write_nirox(robot)


def _nirox_places(source: SourceText) -> PlaceOf:
    from ropsim.nirox import nirox_places

    return nirox_places(source)


_NIROX = RobotFormat(read_nirox, _nirox_places, write_nirox, _nirox_again)

ROBOT_FORMATS: Mapping[str, RobotFormat] = MappingProxyType(
    {
        ".toml": RobotFormat(read_robot_file, robot_file_places, write_robot_file),
        ".urdf": RobotFormat(read_urdf, write=write_urdf),
        ".xacro": RobotFormat(read_urdf),
        ".xml": RobotFormat(read_mjcf, write=write_mjcf),
        ".stp": _NIROX,
        ".step": _NIROX,
    }
)
"""What is read, by the ending of the file name in small letters."""

WRITERS: Mapping[str, Callable[[RobotModel], WrittenRobot]] = MappingProxyType(
    {
        **{ending: one.write for ending, one in ROBOT_FORMATS.items() if one.write is not None},
        ".sdf": write_sdf,
    }
)
"""What is written, likewise; not everything that is written is read again."""
