"""Grouped findings: a finding that repeats in every loop pass is listed once and counted."""

from collections.abc import Iterable

from ropsim.core import Diagnostic, Severity, frozen_dataclass, plural

PASS = "pass"
"""Key of the loop pass in the data of a finding."""
LIST, POINT = "list", "point"
"""Keys of the list of points, and of the number of the point in it, in the data of a finding."""
FOLLOWS = "follows_line"
"""Key of the line from which a finding likely follows, in its data; `follows_source` is next to it."""
STATION = "station"
"""Key of the station in the data of a finding: a program may run at several."""


@frozen_dataclass
class FindingGroup:
    """The same finding at the same place.

    Attributes:
        first: the one that came first; its figures are shown.
        count: how many there are.
        passes: the loop passes (`pass` in the data) in which it came, in order, each once; none where it
            came at points of a list.
        points: numbers of the points of a list (`list` and `point` in the data) at which it came, likewise.
    """

    first: Diagnostic
    count: int
    passes: tuple[int, ...]
    points: tuple[int, ...] = ()

    @property
    def where(self) -> str:
        """Return in which passes or at which points it came, in words; empty where neither is known."""
        if self.points:
            return f"{runs_text('point', self.points)} of `{self.first.data.get(LIST)}`"
        return runs_text("pass", self.passes) if self.passes else ""

    @property
    def follows(self) -> int:
        """Return the line from which it likely follows, 0 for none."""
        line = self.first.data.get(FOLLOWS)
        return line if isinstance(line, int) else 0

    @property
    def cause_text(self) -> str:
        """Return the likely cause in words; empty for a finding without one."""
        return f"likely follows from line {self.follows}" if self.follows else ""


def group_findings(findings: Iterable[Diagnostic]) -> tuple[FindingGroup, ...]:
    """Return groups of equal code and place, in the order of their first member.

    Findings of a run (with a loop `pass` in their data) are one group when code, span, station, list,
    joint and causes agree, regardless of figures in their messages; all others only when the message agrees
    as well, so two different mistakes on one word stay two.
    """
    groups: dict[tuple[object, ...], list[Diagnostic]] = {}
    for finding in findings:
        repeats = finding.span is not None and PASS in finding.data
        own = (finding.data.get(key) for key in ("joint", "cause", LIST))
        sameness = tuple(own) if repeats else finding.message
        where = (finding.span, finding.data.get(STATION), finding.data.get(FOLLOWS))
        key = (finding.code, finding.severity, *where, repr(sameness))
        groups.setdefault(key, []).append(finding)
    return tuple(map(_group, groups.values()))


def below_causes(groups: Iterable[FindingGroup]) -> tuple[FindingGroup, ...]:
    """Return the groups in their order, each that likely follows from a line behind the findings there."""
    found = list(groups)
    placed = [one for one in found if not one.follows]
    for one in found:
        if one.follows:
            at = max((k for k, other in enumerate(placed) if _belongs(one, other)), default=len(placed) - 1)
            placed.insert(at + 1, one)
    return tuple(placed)


def _belongs(one: FindingGroup, other: FindingGroup) -> bool:
    """Return whether a group stands below another: its cause, or a finding with the same cause."""
    cause = (one.first.data.get("follows_source"), one.follows)
    span = other.first.span
    here = (span.source, span.line) if span else None
    return cause in {here, (other.first.data.get("follows_source"), other.follows)}


def count_text(findings: Iterable[Diagnostic]) -> str:
    """Return such as `2 errors, 1 warning`; `no findings` for none."""
    counts = dict.fromkeys(Severity, 0)
    for finding in findings:
        counts[finding.severity] += 1
    parts = [plural(count, severity.value) for severity, count in counts.items() if count]
    return ", ".join(parts) or "no findings"


def runs_text(word: str, numbers: tuple[int, ...], limit: int = 8) -> str:
    """Return such as `passes 1-3, 7`, runs joined, at most `limit` of them; the word is in the singular."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][1] + 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    texts = [str(first) if first == last else f"{first}-{last}" for first, last in runs]
    more = ["…"] if len(texts) > limit else []
    several = {"pass": "passes"}.get(word, f"{word}s")
    return f"{word if len(numbers) == 1 else several} {', '.join(texts[:limit] + more)}"


def place_text(line: int, visit: int) -> str:
    """Return such as ` (line 12 pass 3)`; a line or pass of 0 is not known and left out."""
    parts = [f"{word} {number}" for word, number in (("line", line), ("pass", visit)) if number]
    return f" ({' '.join(parts)})" if parts else ""


def _group(group: list[Diagnostic]) -> FindingGroup:
    points = _numbers(group, POINT) if LIST in group[0].data else ()
    return FindingGroup(group[0], len(group), () if points else _numbers(group, PASS), points)


def _numbers(group: list[Diagnostic], key: str) -> tuple[int, ...]:
    numbers = (finding.data.get(key) for finding in group)
    return tuple(sorted({number for number in numbers if isinstance(number, int)}))
