"""A file of a project that an entity of the controller comes from."""

from pathlib import PurePosixPath
from typing import ClassVar

from ropsim.core import frozen_dataclass
from ropsim.model.findings.number_range import Ranges
from ropsim.model.project_modules import ProjectModule

DIAGRAM_ENDINGS = (".stp", ".step", ".p21")
"""Endings of neutral controllers: block diagrams as exchange files of ISO 10303-21."""
MODULE_ENDING = ".py"
"""Ending of modules in Python."""


@frozen_dataclass
class ControllerFile:
    """A file of the project that an entity of the controller comes from.

    For the joint controller, whose law then has no gains, it is a module or a block diagram; for every other
    entity it is a module.

    Attributes:
        path: of the file in the project.
        text: of the file; empty where it has not been read.
        is_trusted: whether code of the project may run; a block diagram needs no trust.
        modules: of the project that it imports, directly and through one another.
    """

    RANGES: ClassVar[Ranges] = {}

    path: str
    text: str = ""
    is_trusted: bool = False
    modules: tuple[ProjectModule, ...] = ()

    @property
    def is_code(self) -> bool:
        """Return whether the file is a module in Python, which runs in trusted projects only."""
        return PurePosixPath(self.path).suffix.lower() == MODULE_ENDING
