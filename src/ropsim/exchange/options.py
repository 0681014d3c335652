"""What a reader of robot files is told beside the text."""

from collections.abc import Mapping
from dataclasses import field
from types import MappingProxyType

from ropsim.core import frozen_dataclass
from ropsim.exchange.folder import RobotFolder

NO_ARGUMENTS: Mapping[str, str] = MappingProxyType({})


@frozen_dataclass
class ReadOptions:
    """What a reader is told beside the text.

    Attributes:
        tip: name of the link that carries the tool; None for the one that is recognised.
        folder: where meshes and included files are.
        arguments: of a xacro file, by name.
    """

    tip: str | None = None
    folder: RobotFolder = RobotFolder()
    arguments: Mapping[str, str] = field(default_factory=lambda: NO_ARGUMENTS)


STANDARD = ReadOptions()
"""The recognised tip, meshes as they are named, no arguments."""
