"""Collects the diagnostics of one compilation, and converts offsets to spans."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Protocol

from ropsim.core import Diagnostic, Kind, Label, Severity, Span, TextEdit, frozen_dataclass
from ropsim.language.findings import names
from ropsim.language.findings import syntax as kinds
from ropsim.language.syntax.fault import Fault
from ropsim.language.syntax.text import Line

MAX_FINDINGS = 200
MAX_HINTS = 100
"""More hints are left out: a right program with many of them runs."""

_OF_NAMES = frozenset(
    kind.code
    for kind in (
        names.UNKNOWN_TASK,
        names.UNKNOWN_NAME,
        names.UNKNOWN_FRAME,
        names.UNKNOWN_TOOL,
        names.UNKNOWN_SIGNAL,
        names.UNKNOWN_FUNCTION,
        names.UNKNOWN_PATTERN,
        names.UNKNOWN_LIST,
    )
)
"""Findings reported once for each name: usually its declaration is wrong, not each use."""


@frozen_dataclass
class OffsetRange:
    """A range of a line that is no node of its own."""

    start: int
    end: int


class Placed(Protocol):
    """Anything with offsets in its line."""

    @property
    def start(self) -> int:
        """Return the first offset."""
        ...

    @property
    def end(self) -> int:
        """Return the offset after it."""
        ...


class TooManyFindingsError(Exception):
    """The list is full; `compile` ends the phase and goes on to the end."""


class Report:
    """A list of diagnostics with a ceiling.

    Attributes:
        source: name of the text.
        found: findings so far.
        log: the same before further places of one name were put together, to be reported once more elsewhere.
        muted: while true nothing is kept (first pass of the checker).
    """

    __slots__ = ("_first", "_hints", "found", "log", "muted", "source")

    def __init__(self, source: str) -> None:
        self.source = source
        self.found: list[Diagnostic] = []
        self.log: list[Diagnostic] = []
        self.muted = False
        self._first: dict[tuple[str, str | None], int] = {}
        self._hints = 0

    def at(
        self, kind: Kind, line: Line, place: Placed, message: str, hint: str = "", *, fix: str | None = None
    ) -> None:
        """Report a finding on a part of a logical line; `fix` would replace that part.

        Raises:
            TooManyFindingsError: the list is full.
        """
        if self.muted:
            return
        span = line.logical.span(self.source, place.start, place.end)
        edit = TextEdit(span, fix) if fix is not None else None
        self.add(kind.at(span, message, hint=hint, fix=edit))

    def line(self, kind: Kind, line: Line, message: str, hint: str = "") -> None:
        """Report a finding on a whole statement."""
        self.at(kind, line, line, message, hint)

    def add(self, diagnostic: Diagnostic) -> None:
        """Keep a diagnostic; the first one of an unknown name takes the further places with the same fix.

        Raises:
            TooManyFindingsError: the list is full.
        """
        if self.muted:
            return
        self.log.append(diagnostic)
        fix = diagnostic.fix
        if diagnostic.code in _OF_NAMES and (fix is None or fix.span == diagnostic.span):
            mended = fix.replacement if fix is not None else None
            first = self._first.setdefault((diagnostic.message, mended), len(self.found))
            if first < len(self.found):
                self.found[first] = with_place(self.found[first], diagnostic.span)
                return
        if diagnostic.severity is Severity.HINT:
            self._hints += 1
            if self._hints <= MAX_HINTS:
                self.found.append(diagnostic)
            return
        if len(self.found) - min(self._hints, MAX_HINTS) >= MAX_FINDINGS:
            place: Span | None = diagnostic.span
            message = f"more than {MAX_FINDINGS} findings; the rest of the text was not looked at"
            self.found.append(kinds.TOO_MANY.at(place, message, hint="mend the first ones and compile again"))
            raise TooManyFindingsError
        self.found.append(diagnostic)

    def extend(self, diagnostics: Iterable[Diagnostic]) -> None:
        """Keep diagnostics of later phases, as far as the list takes them."""
        try:
            for diagnostic in diagnostics:
                self.add(diagnostic)
        except TooManyFindingsError:
            return

    @property
    def has_errors(self) -> bool:
        """Return whether anything found is an error."""
        return any(d.is_error for d in self.found)

    def in_order(self) -> tuple[Diagnostic, ...]:
        """Return the diagnostics by place, each once."""

        def place(diagnostic: Diagnostic) -> tuple[int, int, int, str]:
            span = diagnostic.span
            last = diagnostic.code == kinds.TOO_MANY.code
            return (last, span.line if span else 0, span.column if span else 0, diagnostic.code)

        unique = {(d.code, d.span, d.message): d for d in self.found}
        return tuple(sorted(unique.values(), key=place))


MAX_PLACES = 200
"""Further places of one finding."""

FIRST_LINE = "first_line"
"""Key of the line of its first place, in the data of a finding at a further one."""

_ALSO = "here, too"


def with_place(first: Diagnostic, place: Span | None) -> Diagnostic:
    """Return a finding that holds at a further place, also; of many places the first ones are kept."""
    if place is None or len(first.secondary) >= MAX_PLACES:
        return first if first.notes else replace(first, notes=("It stands in more places.",))
    return replace(first, secondary=(*first.secondary, Label(place, _ALSO)))


def each_place(findings: Iterable[Diagnostic]) -> Iterator[Diagnostic]:
    """Yield a finding for each place of a mistake, with the change that mends it there."""
    for finding in findings:
        further = [label.span for label in finding.secondary if label.text == _ALSO]
        if not further:
            yield finding
            continue
        others = tuple(label for label in finding.secondary if label.text != _ALSO)
        yield replace(finding, secondary=others)
        where = (Label(finding.span, "here first"),) if finding.span is not None else ()
        data = {**finding.data, FIRST_LINE: finding.span.line if finding.span is not None else 0}
        for span in dict.fromkeys(further):
            fix = TextEdit(span, finding.fix.replacement) if finding.fix is not None else None
            yield replace(finding, span=span, secondary=(*where, *others), fix=fix, data=data)


def finding_of(line: Line, fault: Fault, source: str) -> Diagnostic:
    """Return the finding of a fault.

    Args:
        line: that has it.
        fault: its fault.
        source: name of the text.
    """
    span = line.logical.span(source, fault.start, fault.end)
    place = line.logical.span(source, fault.start - fault.before, fault.end)
    edit = TextEdit(place, fault.fix) if fault.fix else None
    return fault.kind.at(span, fault.message, hint=fault.hint, fix=edit)
