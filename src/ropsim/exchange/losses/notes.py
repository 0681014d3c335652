"""Findings of a reader so far, in the order of the file."""

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from ropsim.core import Diagnostic, Kind, Severity, Span, frozen_dataclass, near
from ropsim.exchange.losses.gathered import Gathered, Topic, shown

MOST_NOTES = 100
"""Numbers of errors and of other findings that are kept: files with more are not mended one by one."""
_NOTHING: Mapping[str, object] = MappingProxyType({})
_LONGEST = 400  # characters of a message: names are as long as their file has them


@frozen_dataclass
class _Absent:
    """Meshes of one folder that are missing: where the first is named, why, and their names in order."""

    span: Span
    why: str
    hint: str
    names: dict[str, None]


class Notes:
    """Findings of one reading."""

    def __init__(self) -> None:
        self._found: list[Diagnostic] = []
        self._counts = {Severity.ERROR: 0, Severity.WARNING: 0, Severity.HINT: 0}
        self._absent: dict[tuple[Kind, str], _Absent] = {}
        self._gathered: dict[Kind, Gathered] = {}

    @property
    def found(self) -> tuple[Diagnostic, ...]:
        """Return the findings, errors first, in the order of the file; findings without a place are last."""
        found = [
            *self._found,
            *(_absence(kind, folder, absent) for (kind, folder), absent in self._absent.items()),
            *(one.finding() for one in self._gathered.values()),
        ]
        files = list(dict.fromkeys(one.span.source for one in found if one.span))
        return tuple(sorted(found, key=lambda one: (not one.is_error, *_place(one, files))))

    @property
    def fatal(self) -> bool:
        """Return whether an error forbids a robot."""
        return self._counts[Severity.ERROR] > 0

    def add(
        self,
        kind: Kind,
        span: Span | None,
        message: str,
        hint: str = "",
        data: Mapping[str, object] | None = None,
    ) -> None:
        """Note a finding, as long as there is room."""
        line = " ".join(message.split())
        line = line if len(line) <= _LONGEST else line[: _LONGEST - 3] + "..."
        self.take(kind.at(span, line, hint=hint, data=data))

    def take(self, finding: Diagnostic) -> None:
        """Note a finding of another module, up to the maximum number."""
        self._counts[finding.severity] += 1
        if self._counts[finding.severity] <= MOST_NOTES:
            self._found.append(finding)

    def gather(self, topic: Topic, span: Span | None, names: Iterable[str] = (), detail: str = "") -> None:
        """Note elements that have a loss or lack; all topics of one kind become one finding.

        Args:
            topic: the loss or lack.
            span: of the first element; the finding has the first place that is given.
            names: of the elements.
            detail: figures of the first element.
        """
        one = self._gathered.setdefault(topic.kind, Gathered(topic.kind, span))
        one.add(topic, names, detail)

    def absent(self, kind: Kind, folder: str, span: Span, mesh: str, why: str, hint: str) -> None:
        """Note a mesh that is missing; missing meshes of one folder become one finding with their number.

        Args:
            kind: of the finding.
            folder: that the mesh is of, such as a package.
            span: of the element that names it.
            mesh: its name.
            why: words behind `is` or `are`, such as `not there`.
            hint: next action.
        """
        one = self._absent.setdefault((kind, folder), _Absent(span, why, hint, {}))
        one.names.setdefault(mesh)

    def unknown(
        self,
        kind: Kind,
        span: Span | None,
        what: str,
        name: str,
        known: Iterable[str],
        data: Mapping[str, object] = _NOTHING,
    ) -> None:
        """Note a name that stands for nothing, with the names that look like it."""
        close = near(name, known) if self._counts[kind.severity] < MOST_NOTES else ()
        hint = f"did you mean `{close[0]}`?" if close else "allowed are the names that the file defines"
        self.add(kind, span, f"{what} `{shown(name)}`, which does not exist", hint, {"near": close, **data})


def _place(one: Diagnostic, files: list[str]) -> tuple[int, int, int]:
    if one.span is None:
        return len(files), 0, 0
    return files.index(one.span.source), one.span.line, one.span.column


def _absence(kind: Kind, folder: str, absent: _Absent) -> Diagnostic:
    """Return the finding of the meshes of one folder."""
    first, count = shown(next(iter(absent.names))), len(absent.names)
    of = f" of `{folder}`" if folder else ""
    message = f"the mesh `{first}` is {absent.why}"
    if count > 1:
        message = f"{count} meshes{of} are {absent.why}, such as `{first}`"
    return kind.at(absent.span, message, hint=absent.hint, data={"folder": folder, "meshes": count})
