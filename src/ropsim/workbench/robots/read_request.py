"""What is requested of a robot file besides its text: tip, arguments, and the files around it."""

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from ropsim.core import Diagnostic, frozen_dataclass, near
from ropsim.model import REQUEST, RobotSource
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


_NAMED = 6  # packages that a hint names
TEXT_ALONE = ReadRequest(None)
"""The recognised tip, and no files around."""


def unasked_packages(name: str, packages: Mapping[str, str]) -> tuple[Diagnostic, ...]:
    """Return findings on packages that are given and that no file of a robot asks for.

    Args:
        name: of the robot file.
        packages: around it, after it was read.
    """
    from ropsim.exchange import Packages

    if not isinstance(packages, Packages):
        return ()
    found = []
    for one in packages.unasked:
        message = f"`{name[:200]}` asks for no package `{one[:60]}`"
        close = near(one, packages.asked, limit=1)
        asked = ", ".join(f"`{other[:60]}`" for other in packages.asked[:_NAMED]) or "none"
        hint = f"did you mean `{close[0]}`?" if close else f"packages that it asks for: {asked}"
        data = {REQUEST: ("package", one), "near": close}
        found.append(REQUEST_UNUSED.at(None, message, hint=hint, data=data))
    return tuple(found)


def unused_request(name: str, words: tuple[str, ...]) -> Diagnostic:
    """Return the finding that requests have no meaning for a robot.

    Args:
        name: of the robot or its file.
        words: the requests.
    """
    message = f"`{name[:200]}` takes no {' and no '.join(f'`{word}`' for word in words)}"
    hint = "these are for URDF, xacro and MJCF; other robots name their interface themselves"
    return REQUEST_UNUSED.at(None, message, hint=hint)
