"""Grouped findings: a finding that repeats in every loop pass is listed once and counted."""

from collections.abc import Iterable

from ropsim.core import Diagnostic, Severity, frozen_dataclass, plural

PASS = "pass"
"""Key of the loop pass in the data of a finding."""
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
        passes: the loop passes (`pass` in the data) in which it came, in order, each once.
    """

    first: Diagnostic
    count: int
    passes: tuple[int, ...]

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

    Findings of a run (with a loop `pass` in their data) are one group when code, span, station, cause and
    joint agree, regardless of figures in their messages; all others only when the message agrees as well, so
    two different mistakes on one word stay two.
    """
    groups: dict[tuple[object, ...], list[Diagnostic]] = {}
    for finding in findings:
        repeats = finding.span is not None and PASS in finding.data
        sameness = finding.data.get("joint") if repeats else finding.message
        where = (finding.span, finding.data.get(STATION), finding.data.get(FOLLOWS))
        key = (finding.code, finding.severity, *where, repr(sameness))
        groups.setdefault(key, []).append(finding)
    return tuple(FindingGroup(group[0], len(group), _passes(group)) for group in groups.values())


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


def passes_text(passes: tuple[int, ...], limit: int = 8) -> str:
    """Return such as `passes 1-3, 7`, runs joined, at most `limit` of them."""
    runs: list[list[int]] = []
    for visit in passes:
        if runs and visit == runs[-1][1] + 1:
            runs[-1][1] = visit
        else:
            runs.append([visit, visit])
    texts = [str(first) if first == last else f"{first}-{last}" for first, last in runs]
    more = ["…"] if len(texts) > limit else []
    return f"{'pass' if len(passes) == 1 else 'passes'} {', '.join(texts[:limit] + more)}"


def place_text(line: int, visit: int) -> str:
    """Return such as ` (line 12 pass 3)`; a line or pass of 0 is not known and left out."""
    parts = [f"{word} {number}" for word, number in (("line", line), ("pass", visit)) if number]
    return f" ({' '.join(parts)})" if parts else ""


def _passes(group: list[Diagnostic]) -> tuple[int, ...]:
    visits = (finding.data.get(PASS) for finding in group)
    return tuple(sorted({visit for visit in visits if isinstance(visit, int)}))
