"""The summary of a run as text for a terminal of 80 columns."""

import math
import textwrap
from collections.abc import Iterable

from ropsim.core import Severity
from ropsim.flow import SLOW
from ropsim.views.characters import clean, fit
from ropsim.views.columns import Cell, columns_text
from ropsim.views.destinations import destinations_text
from ropsim.views.figures import (
    MILLIMETRES,
    MILLIMETRES_PER_SECOND,
    PERCENT,
    UNKNOWN,
    coordinate_scale,
    effort_scale,
    fixed,
    joined_units,
    percent,
    seconds,
    speed_scale,
    with_unit,
)
from ropsim.views.findings import FindingGroup, passes_text, place_text, plural
from ropsim.views.joint_summary import Closeness, JointSummary
from ropsim.views.path_summary import PathSummary
from ropsim.views.style import Style, Tone, paint
from ropsim.views.summary import Summary
from ropsim.views.verdict import Verdict, verdict

COLUMNS = 80
_LEGEND = (
    "  largest torque and speed, their share of the limit: ! from 90 %, !! beyond it",
    "  (speeds by more than 2 %); range left: least distance to the end of a joint's",
    "  range, and the line; lag: largest reference minus attained coordinate",
)

NAMES = 24
SHOWN_TASKS = 10
SHOWN_FINDINGS = 8

_TONES = {Severity.ERROR: Tone.ERROR, Severity.WARNING: Tone.WARNING, Severity.HINT: Tone.HINT}
_SIGNS = {Closeness.FAR: "", Closeness.NEAR: " !", Closeness.BEYOND: " !!"}
_SIGN_TONES = {Closeness.NEAR: Tone.WARNING, Closeness.BEYOND: Tone.ERROR}
_VERDICT_TONES = {Verdict.FAILED: Tone.ERROR, Verdict.DOUBTFUL: Tone.WARNING, Verdict.GOOD: Tone.GOOD}


def terminal_report(summary: Summary, style: Style) -> str:
    """Return the report of a run, about 40 lines of at most 80 columns, ending in a line feed."""
    sections = [
        _title(summary, style),
        _time(summary, style),
        _tasks(summary, style),
        _joints(summary.joints, style),
        _path(summary.path, style),
        _findings(summary, style),
        _estimated(summary),
    ]
    lines = [[line.replace("\u00a0", " ") for line in section] for section in sections if section]
    return "\n\n".join("\n".join(section) for section in lines) + "\n"


def _title(summary: Summary, style: Style) -> list[str]:
    what = clean(summary.title)
    robot = f" on {clean(summary.robot)}" if summary.robot else ""
    state = verdict(summary)
    return [
        paint(fit(what + robot, COLUMNS), Tone.STRONG, style),
        *(["kinematic run: the arm follows its references exactly"] if summary.facts.is_kinematic else []),
        *(paint(line, _VERDICT_TONES[state.kind], style) for line in textwrap.wrap(state.text, COLUMNS)),
        *_unchecked(summary.unchecked.text),
    ]


def _unchecked(text: str) -> list[str]:
    """Return the line on what was not looked at; where it is too long it breaks between its parts."""
    whole = "\u00a0· ".join(part.replace(" ", "\u00a0") for part in text.split(" · "))
    return textwrap.wrap(whole, COLUMNS, subsequent_indent="  ")


def _time(summary: Summary, style: Style) -> list[str]:
    moves = " + ".join(f"{count} {clean(kind)}" for kind, count in summary.moves.items()) or "none"
    invalid = "" if summary.cycle_time_valid else "  " + paint("! not valid, see above", Tone.ERROR, style)
    return [
        f"cycle time   {seconds(summary.cycle_time)} s{invalid}",
        f"in motion    {percent(summary.share_in_motion)} of the cycle time",
        *_settling(summary),
        f"moves        {moves}; {plural(summary.grips, 'grip')}, {plural(summary.releases, 'release')}",
        *([f"parts        {destinations_text(summary.destinations)}"] if summary.destinations else []),
    ]


def _settling(summary: Summary) -> list[str]:
    settling = summary.settling
    if summary.facts.is_kinematic:
        return [f"settling     {UNKNOWN} (a kinematic run has no servo that settles)"]
    share = with_unit(settling.share, PERCENT, 1)
    lines = [f"settling     {seconds(settling.total)} s after moves, {share} of the cycle time"]
    if settling.longest > 0.0:
        place = place_text(settling.line, settling.visit)
        slow = f"; {plural(settling.slow, 'move')} longer than {SLOW * 1e3:g} ms" if settling.slow else ""
        lines.append(f"             longest {settling.longest:.3f} s{place}{slow}")
    return lines


def _tasks(summary: Summary, style: Style) -> list[str]:
    top = min((task.depth for task in summary.tasks), default=0)
    rows = [
        (
            Cell(fit("  " * min(task.depth - top, 4) + clean(task.name), NAMES)),
            Cell(str(task.calls)),
            Cell(seconds(task.total)),
            Cell(seconds(task.mean)),
            Cell(seconds(task.longest)),
        )
        for task in summary.tasks[:SHOWN_TASKS]
    ]
    if not rows:
        return []
    title = ("task", "calls", "total s", "mean s", "longest s")
    return [*columns_text(title, rows, style), *_more(len(summary.tasks) - len(rows), "task")]


def _joints(joints: tuple[JointSummary, ...], style: Style) -> list[str]:
    if not joints:
        return []
    types = [joint.facts.type for joint in joints]
    title = (
        "joint",
        f"torque {joined_units(map(effort_scale, types))}",
        "share",
        f"speed {joined_units(map(speed_scale, types))}",
        "share",
        f"range left {joined_units(map(coordinate_scale, types))}",
        "line",
        f"lag {joined_units(map(coordinate_scale, types))}",
    )
    rows = [_joint_row(joint) for joint in joints]
    return [*columns_text(title, rows, style), *_LEGEND]


def _joint_row(joint: JointSummary) -> tuple[Cell, ...]:
    facts = joint.facts
    coordinate = coordinate_scale(facts.type)
    near = joint.nearest
    return (
        Cell(fit(clean(joint.name), 8)),
        Cell(fixed(joint.effort.size, effort_scale(facts.type), 1)),
        _limit_cell(joint.effort_share, joint.effort_closeness),
        Cell(fixed(joint.speed.size, speed_scale(facts.type), 1)),
        _limit_cell(joint.speed_share, joint.speed_closeness),
        _margin_cell(f"{fixed(near.margin, coordinate, 1)} {near.side}", near.margin),
        Cell(str(near.line) if near.line else ""),
        Cell(fixed(joint.following_max.size, coordinate, 3)),
    )


def _limit_cell(share: float, closeness: Closeness) -> Cell:
    return Cell(percent(share) + _SIGNS[closeness], _SIGN_TONES.get(closeness))


def _margin_cell(text: str, margin: float) -> Cell:
    if not math.isfinite(margin):
        return Cell(text.split(maxsplit=1)[0])
    return Cell(f"!! {text}", Tone.ERROR) if margin < 0.0 else Cell(text)


def _path(path: PathSummary, style: Style) -> list[str]:
    worst, speed = path.worst, path.worst_speed
    if worst is None:
        return []
    figures = ", ".join(
        f"{name} {with_unit(value, MILLIMETRES, 3)}"
        for name, value in (
            ("max", path.max_error),
            ("mean", path.mean_error),
            ("RMS", path.rms_error),
            ("95th percentile", path.p95_error),
        )
    )
    lines = [
        paint(f"LIN path error ({plural(len(path.moves), 'move')})", Tone.QUIET, style),
        f"  {figures}",
        f"  worst at t = {seconds(worst.time)} s{place_text(worst.line, worst.visit)}",
    ]
    if speed is not None:
        lines += [
            f"  path velocity accuracy AV: mean {_signed(path.mean_speed_accuracy)}",
            f"  worst {_signed(speed.speed_accuracy)} of"
            f" {with_unit(speed.command_speed, MILLIMETRES_PER_SECOND, 0)}"
            f"{place_text(speed.line, speed.visit)}",
        ]
    return lines


def _signed(share: float) -> str:
    text = with_unit(share, PERCENT, 2)
    return text if not math.isfinite(share) or share < 0.0 else f"+{text}"


def _findings(summary: Summary, style: Style) -> list[str]:
    lines = [line for group in summary.findings[:SHOWN_FINDINGS] for line in _finding(group, style)]
    return [*lines, *_more(len(summary.findings) - SHOWN_FINDINGS, "finding")]


def _finding(group: FindingGroup, style: Style) -> Iterable[str]:
    first = group.first
    code = f"{first.severity.value}[{first.code}]"
    repeats = f"{group.count} × " if group.count > 1 else ""
    place = f"{clean(str(first.span))}: " if first.span else ""
    text = f"{code} {repeats}{place}{clean(first.message)}"
    if group.count > 1 and group.passes:
        text += f" ({passes_text(group.passes)})"
    wrapped = textwrap.wrap(text, COLUMNS, subsequent_indent="  ", break_on_hyphens=False) or [code]
    yield wrapped[0].replace(code, paint(code, _TONES[first.severity], style), 1)
    yield from wrapped[1:4]


def _estimated(summary: Summary) -> list[str]:
    if not summary.unchecked.estimated:
        return []
    text = "estimated, not from a published source: " + "; ".join(
        clean(entry) for entry in summary.unchecked.estimated
    )
    return textwrap.wrap(text, COLUMNS, subsequent_indent="  ")


def _more(count: int, noun: str) -> list[str]:
    return [f"  … and {plural(count, 'more ' + noun)}"] if count > 0 else []
