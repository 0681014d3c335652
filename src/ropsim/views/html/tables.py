"""The tables of the HTML report."""

from ropsim.core import SourceText
from ropsim.flow import OriginKind
from ropsim.views.markup.markup import table, text
from ropsim.views.summary.device_summary import TaskSummary
from ropsim.views.summary.joint_summary import Closeness, JointSummary, LimitApproach, end_closeness
from ropsim.views.summary.summary import Summary
from ropsim.views.words.figures import (
    UNKNOWN,
    coordinate_scale,
    effort_scale,
    fixed,
    joined_units,
    percent,
    seconds,
    speed_scale,
)


def joint_table(joints: tuple[JointSummary, ...]) -> str:
    """Return extremes per joint against their limits."""
    types = [joint.facts.type for joint in joints]
    coordinate, effort, speed = (
        joined_units(map(scale, types)) for scale in (coordinate_scale, effort_scale, speed_scale)
    )
    speed = speed.replace(" or ", "<br>or ")  # the table is as wide as the page
    header = (
        "joint",
        f"peak torque<br>[{effort}]",
        f"limit<br>[{effort}]",
        "share",
        f"peak speed<br>[{speed}]",
        f"limit<br>[{speed}]",
        "share",
        "peak current<br>[A]",
        f"following<br>error RMS<br>[{coordinate}]",
        f"following<br>error max<br>[{coordinate}]",
    )
    return table("Peaks are magnitudes over the whole run.", header, [_joint_row(joint) for joint in joints])


def approach_table(joints: tuple[JointSummary, ...]) -> str:
    """Return the closest approaches of every joint to its limits."""
    coordinate = joined_units(coordinate_scale(joint.facts.type) for joint in joints)
    titles = tuple(
        title
        for side in ("lower", "upper")
        for title in (
            f"{side} limit<br>[{coordinate}]",
            f"came to<br>[{coordinate}]",
            f"margin<br>[{coordinate}]",
            "at t [s]",
            "line",
        )
    )
    rows = [
        (
            text(joint.name),
            *_approach_cells(joint, joint.nearest_lower, joint.facts.lower),
            *_approach_cells(joint, joint.nearest_upper, joint.facts.upper),
        )
        for joint in joints
    ]
    return table("Closest approach of each joint to its limits.", ("joint", *titles), rows)


def task_table(tasks: tuple[TaskSummary, ...], cycle_time: float) -> str:
    """Return times per task.

    Args:
        tasks: of a station.
        cycle_time: of its program [s].
    """
    rows = [
        (
            text(task.name),
            str(task.calls),
            seconds(task.total),
            _share(task.total, cycle_time),
            seconds(task.mean),
            seconds(task.longest),
        )
        for task in tasks
    ]
    header = ("task", "calls", "total [s]", "of cycle time", "mean [s]", "longest [s]")
    return table(
        "Time from the first to the last instruction of each activation, called tasks included.", header, rows
    )


def called_table(summary: Summary) -> str:
    """Return which tasks of knowledge bases the programs are made of."""
    rows = [(text(one.name), text(one.source), text(one.version)) for one in summary.called]
    caption = "Versions are those of the content: a task that says something else has another one."
    return table(caption, ("task", "text", "version"), rows, "words")


def origin_table(summary: Summary) -> str:
    """Return where the parameters of the arm come from."""
    rows = [
        (
            text(origin.parameters),
            f'<span class="near">{text(origin.kind)}</span>'
            if origin.kind is OriginKind.ESTIMATED
            else text(origin.kind),
            text(origin.source),
        )
        for origin in summary.origins
    ]
    return table("Parameters of the arm and their sources.", ("parameters", "kind", "source"), rows, "words")


def _joint_row(joint: JointSummary) -> tuple[str, ...]:
    facts = joint.facts
    effort, speed, coordinate = (
        effort_scale(facts.type),
        speed_scale(facts.type),
        coordinate_scale(facts.type),
    )
    return (
        text(joint.name),
        fixed(joint.effort.size, effort, 1),
        fixed(facts.max_effort, effort, 1),
        marked(percent(joint.effort_share), joint.effort_closeness),
        fixed(joint.speed.size, speed, 1),
        fixed(facts.max_speed, speed, 1),
        marked(percent(joint.speed_share), joint.speed_closeness),
        fixed(joint.current.size, effort, 2),
        fixed(joint.following_rms, coordinate, 3),
        fixed(joint.following_max.size, coordinate, 3),
    )


def _approach_cells(joint: JointSummary, approach: LimitApproach, limit: float) -> tuple[str, ...]:
    scale = coordinate_scale(joint.facts.type)
    return (
        fixed(limit, scale, 1),
        fixed(approach.coordinate, scale, 1),
        marked(fixed(approach.margin, scale, 1), end_closeness(approach.margin, joint.facts.type)),
        seconds(approach.time),
        _line(approach.line),
    )


def _line(line: int) -> str:
    return str(line) if line else UNKNOWN


def _share(part: float, whole: float) -> str:
    return percent(part / whole) if whole > 0.0 else UNKNOWN


def marked(figure: str, closeness: Closeness) -> str:
    """Return a figure with how it stands to its limit before it, where it is near or beyond that; HTML."""
    if closeness is Closeness.FAR:
        return figure
    kind = "mark" if closeness is Closeness.BEYOND else "near"
    return f'<span class="{kind}">{closeness.value} {figure}</span>'


_LONGEST = 200
"""Characters of a line that are written; the page shows as many as there is room for."""


def source_cell(source: SourceText | None, line: int) -> str:
    """Return a line of a program, from 1, as code that is cut where it has no room; 0 for no line."""
    if source is None or not line:
        return UNKNOWN
    shown = text(source.line(line).strip()[:_LONGEST])
    return f'<code class="source" title="{shown}">{shown}</code>'
