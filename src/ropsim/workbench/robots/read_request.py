"""What is requested of a robot file besides its text: tip, arguments, and the files around it."""

from pathlib import Path
from typing import TYPE_CHECKING

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.model import RobotSource
from ropsim.workbench.project_diagnostics import REQUEST_UNUSED

if TYPE_CHECKING:  # it is loaded when the first file of its formats is met
    from ropsim.exchange import ReadOptions


@frozen_dataclass
class ReadRequest:
    """How a robot file is read.

    Attributes:
        source: the file, and what is requested of it; None for a text alone, around which nothing is read.
        project: folder of the project that the file is in, from which its path counts; None for a file
            anywhere on the disk.
    """

    source: RobotSource | None
    project: Path | None = None

    @property
    def words(self) -> tuple[str, ...]:
        """Return the names of all requests, as they are on the command line."""
        if self.source is None:
            return ()
        named = ("tip", self.source.tip), ("package", self.source.packages), ("arg", self.source.arguments)
        return tuple(word for word, value in named if value)

    @property
    def options(self) -> "ReadOptions":
        """Return the options of a reader; files around are looked for when they are needed."""
        from ropsim.exchange import ReadOptions, around_file, in_project

        source = self.source
        if source is None:
            return ReadOptions()
        packages = dict(source.packages)
        if self.project is None:
            folder = around_file(Path(source.path), packages)
        else:
            folder = in_project(self.project, source.path, packages)
        return ReadOptions(source.tip or None, folder, dict(source.arguments))


TEXT_ALONE = ReadRequest(None)
"""The recognised tip, and no files around."""


def unused_request(name: str, words: tuple[str, ...]) -> Diagnostic:
    """Return the finding that requests have no meaning for a robot.

    Args:
        name: of the robot or its file.
        words: the requests.
    """
    message = f"`{name[:200]}` takes no {' and no '.join(f'`{word}`' for word in words)}"
    hint = "these are for URDF, xacro and MJCF; other robots name their interface themselves"
    return REQUEST_UNUSED.at(None, message, hint=hint)
