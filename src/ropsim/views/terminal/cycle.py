"""Composition of the cycle time, as text for a terminal."""

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias

from ropsim.views.cycle import CriticalShare, CycleParts, CycleTime
from ropsim.views.terminal.columns import Style, TableCell, columns_text
from ropsim.views.words.characters import clean, fit
from ropsim.views.words.figures import MILLIMETRES, UNKNOWN, percent, seconds, with_unit

SHOWN_LINES = 6
SHOWN_TASKS = 6
NO_STATEMENT = "no statement"
"""Name of the time that no statement of a program took, such as that of a hold between two of them."""
_NAMES = 18
_Column: TypeAlias = tuple[str, Callable[[CycleParts], float]]
_SETTLING = "settling"
"""Left out where nothing settles: a kinematic run has no servo that could."""
_COLUMNS: tuple[_Column, ...] = (
    ("total", lambda parts: parts.total),
    ("motion", lambda parts: parts.motion),
    ("zones", lambda parts: parts.blending),
    (_SETTLING, lambda parts: parts.settling),
    ("gripper", lambda parts: parts.gripper),
    ("waits", lambda parts: parts.waits),
    ("other", lambda parts: parts.other),
)


def cycle_lines(cycle: CycleTime, style: Style) -> list[str]:
    """Return the parts by task, and the lines that take longest, as two tables; nothing for no time."""
    if not cycle.whole.total > 0.0:
        return []
    tasks = cycle.tasks if len(cycle.tasks) > 1 else ()
    columns = [one for one in _COLUMNS if one[0] != _SETTLING or cycle.whole.settling > 0.0]
    title = ("time in s", *(name for name, _ in columns))
    rows = [_parts_row(task.name or NO_STATEMENT, task.parts, columns) for task in tasks[:SHOWN_TASKS]]
    if len(tasks) > SHOWN_TASKS:
        rows.append((TableCell(f"… {len(tasks) - SHOWN_TASKS} more"), *(TableCell("") for _ in title[1:])))
    rows.append(_parts_row("all", cycle.whole, columns))
    return [*columns_text(title, rows, style), *_slowest(cycle, style)]


def critical_text(critical: CriticalShare | None) -> str:
    """Return which limit sets a time, and for how much of the way: `joint 1 speed 62 %`."""
    if critical is None:
        return UNKNOWN
    whose = f"joint {clean(critical.joint)}" if critical.joint else "path"
    return f"{whose} {critical.quantity.value} {percent(critical.share)}"


def zone_text(zone: float) -> str:
    """Return a zone, `stop` for none."""
    return with_unit(zone, MILLIMETRES, 1) if zone > 0.0 else "stop"


def _parts_row(name: str, parts: CycleParts, columns: Sequence[_Column]) -> tuple[TableCell, ...]:
    return (TableCell(fit(clean(name), _NAMES)), *(TableCell(seconds(part(parts))) for _, part in columns))


def _slowest(cycle: CycleTime, style: Style) -> list[str]:
    """Return the lines that take longest, with the limit that sets the time of their moves."""
    whole = cycle.whole.total
    rows = [
        (
            TableCell(f"line {line.line}"),
            TableCell(str(line.passes)),
            TableCell(seconds(line.parts.total)),
            TableCell(percent(line.parts.total / whole if whole > 0.0 else math.nan)),
            TableCell(zone_text(line.zone) if line.parts.moving > 0.0 else ""),
            TableCell(critical_text(line.critical) if line.parts.moving > 0.0 else ""),
        )
        for line in cycle.lines[:SHOWN_LINES]
        if line.line
    ]
    if not rows:
        return []
    title = ("slowest lines", "times", "total s", "share", "zone", "at its limit for")
    return ["", *columns_text(title, rows, style)]
