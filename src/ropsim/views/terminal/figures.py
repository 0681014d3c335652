"""The figures of a run, or of one of its stations, as lines for a terminal of 80 columns."""

import math

from ropsim.core import plural
from ropsim.flow import SLOW
from ropsim.views.summary.device_summary import TaskSummary
from ropsim.views.summary.findings import place_text
from ropsim.views.summary.joint_summary import Closeness, JointSummary
from ropsim.views.summary.station_summary import Figures
from ropsim.views.summary.summary import Summary
from ropsim.views.terminal.columns import Style, TableCell, Tone, columns_text, paint
from ropsim.views.words.characters import clean, fit, width
from ropsim.views.words.figures import (
    PERCENT,
    UNKNOWN,
    WITHOUT_DRIVES,
    coordinate_scale,
    effort_scale,
    fixed,
    joined_units,
    percent,
    seconds,
    speed_scale,
    with_unit,
)

COLUMNS = 80
RANGE_LEGEND = "  ! less than 1° or 1 mm of the range left, !! beyond its end"
"""Meanings of the signs of a range; printed below `LEGEND` if there is one."""
LEGEND = (
    "  largest torque and speed, their share of the limit: ! torque from 90 % on,",
    "  !! beyond it (speeds: 2 %); range left: least distance to the end of a joint's",
    "  range, and the line; lag: largest reference minus attained coordinate",
)

NAMES = 24
"""Columns that the name of a joint or task takes at most."""
SHOWN_TASKS = 10

_SIGNS = {Closeness.FAR: "", Closeness.NEAR: " !", Closeness.BEYOND: " !!"}
_SIGN_TONES = {Closeness.NEAR: Tone.WARNING, Closeness.BEYOND: Tone.ERROR}


def cycle_time_line(figures: Figures, summary: Summary, style: Style) -> str:
    """Return the cycle time, and whether it is that of the program."""
    mark = summary.by_hand.mark and "  " + paint(f"! {summary.by_hand.mark}", Tone.WARNING, style)
    if not summary.cycle_time_valid:
        mark = "  " + paint("! not valid, see above", Tone.ERROR, style)
    return f"cycle time   {seconds(figures.cycle_time)} s{mark}"


def effort_lines(figures: Figures, summary: Summary) -> list[str]:
    """Return the lines on motion time, settling and waits of an arm, and its moves."""
    moves = " + ".join(f"{count} {clean(kind)}" for kind, count in figures.moves.items()) or "none"
    return [
        f"in motion    {percent(figures.share_in_motion)} of the cycle time",
        *_settling(figures, summary),
        *_waiting(figures),
        f"moves        {moves}; {_gripper(figures)}",
    ]


def _gripper(figures: Figures) -> str:
    """Return how often a gripper closed on a part, on nothing, and opened."""
    empty = [plural(figures.empty_grips, "empty grip")] if figures.empty_grips else []
    return ", ".join((plural(figures.grips, "grip"), *empty, plural(figures.releases, "release")))


def _settling(figures: Figures, summary: Summary) -> list[str]:
    settling = figures.settling
    if summary.facts.is_kinematic:
        return [f"settling     {UNKNOWN} (a kinematic run has no servo that settles)"]
    if not figures.is_driven:
        return [f"settling     {WITHOUT_DRIVES}"]
    share = with_unit(settling.share, PERCENT, 1)
    lines = [f"settling     {seconds(settling.total)} s after moves, {share} of the cycle time"]
    if settling.longest > 0.0:
        place = place_text(settling.line, settling.visit)
        slow = f"; {plural(settling.slow, 'move')} longer than {SLOW * 1e3:g} ms" if settling.slow else ""
        lines.append(f"             longest {settling.longest:.3f} s{place}{slow}")
    return lines


def _waiting(figures: Figures) -> list[str]:
    """Return how long the program stood at waits, and where longest; nothing where it did not."""
    waiting = figures.waiting
    if not waiting.total > 0.0:
        return []
    place = place_text(waiting.line, waiting.visit)
    return [
        f"waiting      {seconds(waiting.total)} s, {percent(waiting.share)} of the cycle time",
        f"             longest {seconds(waiting.longest)} s{place}",
    ]


def task_lines(tasks: tuple[TaskSummary, ...], style: Style) -> list[str]:
    """Return the times of the tasks as a table; nothing where there is none."""
    top = min((task.depth for task in tasks), default=0)
    rows = [
        (
            TableCell(fit("  " * min(task.depth - top, 4) + clean(task.name), NAMES)),
            TableCell(str(task.calls)),
            TableCell(seconds(task.total)),
            TableCell(seconds(task.mean)),
            TableCell(seconds(task.longest)),
        )
        for task in tasks[:SHOWN_TASKS]
    ]
    if not rows:
        return []
    title = ("task", "calls", "total s", "mean s", "longest s")
    return [*columns_text(title, rows, style), *more(len(tasks) - len(rows), "task")]


def joint_lines(joints: tuple[JointSummary, ...], style: Style) -> list[str]:
    """Return the motion of the joints as a table, whose signs `LEGEND` explains; nothing without joints."""
    if not joints:
        return []
    rows = [_joint_row(joint) for joint in joints]
    beside, below = (_joint_titles(joints, between) for between in (" ", "\n"))
    widest = max(width(line) for line in columns_text(beside, rows, Style.PLAIN))
    return columns_text(beside if widest <= COLUMNS else below, rows, style)


def legend(joints: tuple[JointSummary, ...]) -> list[str]:
    """Return the meanings of signs in the table of joints; empty without joints."""
    if not joints:
        return []
    is_marked = any(one.margin_closeness is not Closeness.FAR for one in joints)
    return [*LEGEND, RANGE_LEGEND] if is_marked else [*LEGEND]


def _joint_titles(joints: tuple[JointSummary, ...], between: str) -> tuple[str, ...]:
    """Return the titles of the columns, with `between` before each unit."""
    types = [joint.facts.type for joint in joints]
    coordinate = joined_units(map(coordinate_scale, types))
    return (
        "joint",
        f"torque{between}{joined_units(map(effort_scale, types))}",
        "share",
        f"speed{between}{joined_units(map(speed_scale, types))}",
        "share",
        f"range left{between}{coordinate}",
        "line",
        f"lag{between}{coordinate}",
    )


def more(count: int, noun: str) -> list[str]:
    """Return the line that says how many things are not shown; nothing where all are."""
    return [f"  … and {plural(count, 'more ' + noun)}"] if count > 0 else []


def _joint_row(joint: JointSummary) -> tuple[TableCell, ...]:
    facts = joint.facts
    coordinate = coordinate_scale(facts.type)
    near = joint.nearest
    return (
        TableCell(fit(clean(joint.name), NAMES)),
        TableCell(fixed(joint.effort.size, effort_scale(facts.type), 1)),
        _limit_cell(joint.effort_share, joint.effort_closeness),
        TableCell(fixed(joint.speed.size, speed_scale(facts.type), 1)),
        _limit_cell(joint.speed_share, joint.speed_closeness),
        _margin_cell(f"{fixed(near.margin, coordinate, 1)} {near.side}", joint),
        TableCell(str(near.line) if near.line else ""),
        TableCell(fixed(joint.following_max.size, coordinate, 3)),
    )


def _limit_cell(share: float, closeness: Closeness) -> TableCell:
    return TableCell(percent(share) + _SIGNS[closeness], _SIGN_TONES.get(closeness))


def _margin_cell(text: str, joint: JointSummary) -> TableCell:
    if math.isinf(joint.facts.lower) and math.isinf(joint.facts.upper):
        return TableCell("endless")
    if not math.isfinite(joint.nearest.margin):
        return TableCell(text.split(maxsplit=1)[0])
    closeness = joint.margin_closeness
    return TableCell(f"{_SIGNS[closeness]} {text}".strip(), _SIGN_TONES.get(closeness))
