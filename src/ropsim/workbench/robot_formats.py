"""The formats of robot files: a new one is an entry here; it is loaded when its first file is met."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from ropsim.core import SourceText, frozen_dataclass
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


def _read_urdf(source: SourceText) -> ReadRobot:
    from ropsim.exchange import read_urdf

    return read_urdf(source)


def _write_urdf(robot: RobotModel) -> WrittenRobot:
    from ropsim.exchange import write_urdf

    return write_urdf(robot)


def _read_mjcf(source: SourceText) -> ReadRobot:
    from ropsim.exchange import read_mjcf

    return read_mjcf(source)


def _write_mjcf(robot: RobotModel) -> WrittenRobot:
    from ropsim.exchange import write_mjcf

    return write_mjcf(robot)


def _write_sdf(robot: RobotModel) -> WrittenRobot:
    from ropsim.exchange import write_sdf

    return write_sdf(robot)


def _read_nirox(source: SourceText) -> ReadRobot:
    from ropsim.nirox import read_nirox

    return read_nirox(source)


def _write_nirox(robot: RobotModel) -> WrittenRobot:
    from ropsim.nirox import write_nirox

    return write_nirox(robot)


def _nirox_again(robot: RobotModel, read: ReadRobot) -> WrittenRobot:
    from ropsim.nirox import ReadNirox, write_nirox

    return write_nirox(robot, read.beside) if isinstance(read, ReadNirox) else write_nirox(robot)


def _nirox_places(source: SourceText) -> PlaceOf:
    from ropsim.nirox import nirox_places

    return nirox_places(source)


_NIROX = RobotFormat(_read_nirox, _nirox_places, _write_nirox, _nirox_again)

ROBOT_FORMATS: Mapping[str, RobotFormat] = MappingProxyType(
    {
        ".toml": RobotFormat(read_robot_file, robot_file_places, write_robot_file),
        ".urdf": RobotFormat(_read_urdf, write=_write_urdf),
        ".xacro": RobotFormat(_read_urdf),
        ".xml": RobotFormat(_read_mjcf, write=_write_mjcf),
        ".stp": _NIROX,
        ".step": _NIROX,
    }
)
"""What is read, by the ending of the file name in small letters."""

WRITERS: Mapping[str, Callable[[RobotModel], WrittenRobot]] = MappingProxyType(
    {
        **{ending: one.write for ending, one in ROBOT_FORMATS.items() if one.write is not None},
        ".sdf": _write_sdf,
    }
)
"""What is written, likewise; not everything that is written is read again."""
