"""A diagnostic: the fault, its place, the allowed values and the next action.

Diagnostics are values. Every one is made from a `Kind`, which owns the code, the slug and the
explanation that `ropsim explain` prints; see `ropsim.core.catalogue`.
"""

from collections.abc import Mapping
from dataclasses import field
from enum import Enum

from ropsim.core.frozen_dataclass import frozen_dataclass
from ropsim.core.span import Span


class Severity(Enum):
    """How bad a finding is; only errors make a command exit with 1."""

    ERROR = "error"
    WARNING = "warning"
    HINT = "hint"

    @property
    def rank(self) -> int:
        """Return 0 for the worst."""
        return list(Severity).index(self)


class Category(Enum):
    """Class of a finding for programs that treat findings of a class alike; its kind states it.

    Attributes:
        OTHER: none of the others.
        SYNTAX: a text cannot be read, whatever the cell is.
        USAGE: a command was called wrongly: its exit code is 2.
        UNFINISHED: a program ended before its own end, so the cycle time does not hold.
        STOPPED: a live run was ended by hand before the end of its program.
        COLLISION: two bodies penetrate each other.
        OUT_OF_TIME: the time that work may take was over.
        ENGINE_LOST: the process that carries out the work ended.
        DAMAGED: files of the installation are missing or changed.
    """

    OTHER = "other"
    SYNTAX = "syntax"
    USAGE = "usage"
    UNFINISHED = "unfinished"
    STOPPED = "stopped"
    COLLISION = "collision"
    OUT_OF_TIME = "out-of-time"
    ENGINE_LOST = "engine-lost"
    DAMAGED = "damaged"


@frozen_dataclass
class Label:
    """A second place that belongs to a diagnostic, with a few words about it."""

    span: Span
    text: str


@frozen_dataclass
class TextEdit:
    """A replacement that would mend the text."""

    span: Span
    replacement: str


@frozen_dataclass
class Diagnostic:
    """One finding.

    Attributes:
        code: stable code such as `M502`.
        slug: the pattern found, such as `joint-out-of-range`.
        severity: error, warning or hint.
        message: one line: the found and the allowed values, with units.
        span: the place, or None where there is no text.
        label: words under the marked text.
        secondary: further places.
        notes: whole sentences that explain.
        hint: next action.
        fix: a replacement, where one is certain.
        data: figures behind the message; keys carry the unit (`limit_rad`).
        category: class of the finding, as its kind states it.
    """

    code: str
    slug: str
    severity: Severity
    message: str
    span: Span | None = None
    label: str = ""
    secondary: tuple[Label, ...] = ()
    notes: tuple[str, ...] = ()
    hint: str = ""
    fix: TextEdit | None = None
    data: Mapping[str, object] = field(default_factory=dict, hash=False)
    category: Category = Category.OTHER

    @property
    def is_error(self) -> bool:
        """Return whether the severity is error."""
        return self.severity is Severity.ERROR

    def __str__(self) -> str:
        place = f"{self.span}: " if self.span else ""
        return f"{place}{self.severity.value}[{self.code}] {self.slug}: {self.message}"


class RopsimError(Exception):
    """Wrong use of the API; carries the diagnostic that describes the error.

    Mistakes in programs, cells and models are diagnostics (values), not exceptions.
    """

    def __init__(self, diagnostic: Diagnostic) -> None:
        super().__init__(str(diagnostic) + (f" ({diagnostic.hint})" if diagnostic.hint else ""))
        self.diagnostic = diagnostic
