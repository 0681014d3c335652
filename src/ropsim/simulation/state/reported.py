"""Findings of plans that come again at a line: reported once, with how often and where they came first."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from ropsim.core import Diagnostic, Span
from ropsim.flow import Event, ListedPoint, MoveEvent, SkipEvent

Pass = tuple[str, int]
"""A list and the number of a point of it; without a list the number of a loop pass."""
_Sort = tuple[str, str, Span | str, str, str]
"""Station, code, place, cause or joint, and the list of the point, empty for none."""


@dataclass(slots=True)
class _Reported:
    """Findings of one sort.

    Attributes:
        first: pass in which it came first, and how often its instruction had been executed.
        numbers: of its findings among those that are reported; all are of that pass.
        passes: in which it came, in their order.
    """

    first: tuple[Pass, int]
    numbers: list[int]
    passes: dict[Pass, None]


class ReportedOnce:
    """Which findings of plans have been reported; the passes of the others are counted.

    Findings are of one sort if station, code, place, cause or joint, and list of points agree: their numbers
    may differ.
    """

    def __init__(self) -> None:
        self._sorts: dict[_Sort, _Reported] = {}

    def is_new(self, station: str, finding: Diagnostic, number: int) -> bool:
        """Return whether a finding is to be reported: it is the first of its sort, or comes in the same pass.

        Args:
            station: its name.
            finding: of a plan.
            number: that it gets among the findings of the run.
        """
        sameness = finding.data.get("cause", finding.data.get("joint", ""))
        here = _pass_of(finding), _number(finding.data, "pass")
        sort = station, finding.code, finding.span or finding.message, str(sameness), here[0][0]
        reported = self._sorts.setdefault(sort, _Reported(here, [], {}))
        reported.passes[here[0]] = None
        if here != reported.first:
            return False
        reported.numbers.append(number)
        return True

    def counted(self, findings: Sequence[Diagnostic], events: Iterable[Event]) -> list[Diagnostic]:
        """Return the findings of a run; those of plans say how often they came, all to which point.

        Args:
            findings: of the run.
            events: of the run, with all moves that were made or left out.
        """
        passes: dict[tuple[str, Span], dict[Pass, None]] = {}
        for one in events:
            if isinstance(one, MoveEvent | SkipEvent) and one.span and one.origin:
                point = one.origin.point
                here = (point.list, point.number) if point else ("", one.visit)
                passes.setdefault((one.station, one.span), {})[here] = None
        found = [_placed(one) for one in findings]
        for (station, _, place, _, list_), reported in self._sorts.items():
            if len(reported.passes) > 1 and isinstance(place, Span):
                whole = sum(name == list_ for name, _ in passes.get((station, place), {}))
                for number in reported.numbers:
                    found[number] = _counted(findings[number], tuple(reported.passes), whole)
        return found


def _pass_of(finding: Diagnostic) -> Pass:
    data = finding.data
    return (str(data["list"]), _number(data, "point")) if "list" in data else ("", _number(data, "pass"))


def _number(data: Mapping[str, object], key: str) -> int:
    number = data.get(key)
    return number if isinstance(number, int) else 0


def _point_of(finding: Diagnostic) -> ListedPoint | None:
    """Return the point of a list at which a finding is; None at none."""
    data = finding.data
    if "list" not in data:
        return None
    number, line = _number(data, "point"), _number(data, "list_line")
    return ListedPoint(str(data["list"]), number, str(data.get("list_source", "")), line)


def _placed(finding: Diagnostic) -> Diagnostic:
    """Return a finding that says its point of a list; unchanged without one."""
    point = _point_of(finding)
    if point is None:
        return finding
    return replace(finding, message=f"{point}: {finding.message}", label="")


def _counted(finding: Diagnostic, passes: Sequence[Pass], whole: int) -> Diagnostic:
    """Return a finding that says in how many of all passes it came, and in which one first."""
    count, point = len(passes), _point_of(finding)
    data = {**finding.data, "count": count, "of": whole}
    if point is not None:
        many = f"{count} of {whole} points" if count < whole else f"all {count} points"
        words = f"{many} of `{point.list}`, first {str(point).replace(f' of `{point.list}`', '')}"
    else:
        many = f"{count} of {whole} passes" if count < whole else f"all {count} passes"
        words = f"{many}, first pass {passes[0][1]}"
    return replace(finding, message=f"{words}: {finding.message}", label="", data=data)
