"""Composition of the cycle time, as tables of the HTML report."""

from collections.abc import Callable

from ropsim.core import SourceText
from ropsim.views.cycle import CycleParts, CycleTime
from ropsim.views.html.tables import source_cell
from ropsim.views.markup.markup import table, text
from ropsim.views.terminal.cycle import NO_STATEMENT, critical_text, zone_text
from ropsim.views.words.figures import UNKNOWN, percent, seconds

_ALWAYS: tuple[tuple[str, Callable[[CycleParts], float]], ...] = (
    ("total<br>[s]", lambda parts: parts.total),
    ("motion<br>[s]", lambda parts: parts.motion),
)
_WHERE_ANY: tuple[tuple[str, Callable[[CycleParts], float]], ...] = (
    ("in zones<br>[s]", lambda parts: parts.blending),
    ("settling<br>[s]", lambda parts: parts.settling),
    ("gripper<br>[s]", lambda parts: parts.gripper),
    ("signals<br>[s]", lambda parts: parts.signals),
    ("partners<br>[s]", lambda parts: parts.partners),
    ("timers<br>[s]", lambda parts: parts.timers),
    ("other<br>[s]", lambda parts: parts.other),
)
"""A column of zeros is left out: the tables are no wider than the page."""


def cycle_section(cycle: CycleTime, source: SourceText | None, of: str) -> str:
    """Return the section on the parts of a cycle time; nothing for no time.

    Args:
        cycle: of a station.
        source: text of its program, None where it is not known.
        of: suffix of the heading, where there are several stations; HTML.
    """
    if not cycle.whole.total > 0.0:
        return ""
    columns = (*_ALWAYS, *(one for one in _WHERE_ANY if one[1](cycle.whole) > 0.0))
    titles = tuple(title for title, _ in columns)

    def times(parts: CycleParts) -> tuple[str, ...]:
        return tuple(seconds(part(parts)) for _, part in columns)

    rows = [(text(task.name or NO_STATEMENT), *times(task.parts)) for task in cycle.tasks]
    tasks = table(
        "Where the time goes, by task without those that it calls; the parts sum to the cycle time.",
        ("task", *titles),
        [*rows, ("all", *times(cycle.whole))],
    )
    lines = table(
        "The same by source line, and the limit at which its moves are for longest.",
        ("line", "times", *titles, "of cycle<br>time", "zone", "at its limit for", "source"),
        [
            (
                str(line.line) if line.line else UNKNOWN,
                str(line.passes),
                *times(line.parts),
                percent(line.parts.total / cycle.whole.total),
                zone_text(line.zone) if _moves(line.parts) else "",
                text(critical_text(line.critical)) if _moves(line.parts) else "",
                source_cell(source, line.line),
            )
            for line in cycle.lines
        ],
    )
    return f"<section><h2>Cycle time{of}</h2>\n{tasks}{lines}</section>\n"


def _moves(parts: CycleParts) -> bool:
    return parts.moving > 0.0
