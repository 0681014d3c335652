"""Of what the cycle time consists, as tables of the HTML report."""

from ropsim.core import SourceText
from ropsim.views.cycle import CycleParts, CycleTime
from ropsim.views.cycle_text import NO_STATEMENT, critical_text, zone_text
from ropsim.views.figures import UNKNOWN, percent, seconds
from ropsim.views.markup import table, text

_PARTS = (
    "total<br>[s]",
    "motion<br>[s]",
    "in zones<br>[s]",
    "settling<br>[s]",
    "gripper<br>[s]",
    "signals<br>[s]",
    "partners<br>[s]",
    "timers<br>[s]",
    "other<br>[s]",
)


def cycle_section(cycle: CycleTime, source: SourceText | None, of: str) -> str:
    """Return the section on the parts of a cycle time; nothing for no time.

    Args:
        cycle: of a station.
        source: text of its program, None where it is not known.
        of: what is added to the heading, where there are several stations; HTML.
    """
    if not cycle.whole.total > 0.0:
        return ""
    rows = [(text(task.name or NO_STATEMENT), *_parts(task.parts)) for task in cycle.tasks]
    tasks = table(
        "Where the time goes, by task without those that it calls; the parts sum to the cycle time.",
        ("task", *_PARTS),
        [*rows, ("all", *_parts(cycle.whole))],
    )
    lines = table(
        "The same by source line, and the limit at which its moves are for longest.",
        ("line", "times", *_PARTS, "of cycle<br>time", "zone", "at its limit for", "source"),
        [
            (
                str(line.line) if line.line else UNKNOWN,
                str(line.passes),
                *_parts(line.parts),
                percent(line.parts.total / cycle.whole.total),
                zone_text(line.zone) if _moves(line.parts) else "",
                text(critical_text(line.critical)) if _moves(line.parts) else "",
                f"<code>{text(source.line(line.line).strip()[:60])}</code>"
                if source and line.line
                else UNKNOWN,
            )
            for line in cycle.lines
        ],
    )
    return f"<section><h2>Cycle time{of}</h2>\n{tasks}{lines}</section>\n"


def _parts(parts: CycleParts) -> tuple[str, ...]:
    times = (
        parts.total,
        parts.motion,
        parts.blending,
        parts.settling,
        parts.gripper,
        parts.signals,
        parts.partners,
        parts.timers,
        parts.other,
    )
    return tuple(seconds(time) for time in times)


def _moves(parts: CycleParts) -> bool:
    return parts.motion + parts.blending > 0.0
