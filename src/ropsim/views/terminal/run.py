"""The summary of a run as text for a terminal of 80 columns."""

import textwrap
from collections.abc import Iterable

from ropsim.core import Severity
from ropsim.views.summary.device_summary import device_text
from ropsim.views.summary.findings import FindingGroup
from ropsim.views.summary.station_summary import StationSummary
from ropsim.views.summary.summary import Summary
from ropsim.views.summary.verdict import Verdict, verdict
from ropsim.views.terminal.accuracy import accuracy_lines
from ropsim.views.terminal.columns import Style, Tone, paint
from ropsim.views.terminal.cycle import cycle_lines
from ropsim.views.terminal.energy import contact_lines, drive_lines, energy_lines
from ropsim.views.terminal.figures import (
    COLUMNS,
    cycle_time_line,
    effort_lines,
    joint_lines,
    legend,
    more,
    task_lines,
)
from ropsim.views.ways import way_lines
from ropsim.views.words.characters import clean, fit
from ropsim.views.words.destinations import destinations_text

SHOWN_FINDINGS = 8
SHORT_VERSION = 8
"""Digits of the version of a task that are shown."""

_TONES = {Severity.ERROR: Tone.ERROR, Severity.WARNING: Tone.WARNING, Severity.HINT: Tone.HINT}
_VERDICT_TONES = {Verdict.FAILED: Tone.ERROR, Verdict.DOUBTFUL: Tone.WARNING, Verdict.GOOD: Tone.GOOD}


def terminal_report(summary: Summary, style: Style) -> str:
    """Return the report of a run, about 40 lines of at most 80 columns, ending in a line feed.

    Where the run has several stations each has a separate block, below the totals.
    """
    several = len(summary.stations) > 1
    sections = [
        _title(summary, style),
        *(_blocks(summary, style) if several else _whole(summary, style)),
        way_lines(summary.facts),
        _findings(summary, style),
        _called(summary),
        _estimated(summary),
    ]
    lines = [[line.replace("\u00a0", " ") for line in section] for section in sections if section]
    return "\n\n".join("\n".join(section) for section in lines) + "\n"


def _whole(summary: Summary, style: Style) -> list[list[str]]:
    """Return the sections of a run with one station."""
    time = [cycle_time_line(summary, summary, style), *effort_lines(summary, summary)]
    time += [line for one in summary.stations for line in (*energy_lines(one), *contact_lines(one))]
    time += _cell_lines(summary)
    joints = [*joint_lines(summary.joints, style), *legend(summary.joints)]
    cycles = [cycle_lines(one.cycle, style) for one in summary.stations]
    drives = [drive_lines(one.drives, style) for one in summary.stations]
    return [time, task_lines(summary.tasks, style), *cycles, joints, *drives, accuracy_lines(summary, style)]


def _blocks(summary: Summary, style: Style) -> list[list[str]]:
    """Return the sections of a run with several stations: first the cell, then each station."""
    sections = [[cycle_time_line(summary, summary, style), *_cell_lines(summary)]]
    for one in summary.stations:
        sections += [
            [
                paint(fit(_station_title(one), COLUMNS), Tone.STRONG, style),
                cycle_time_line(one, summary, style),
                *effort_lines(one, summary),
                *energy_lines(one),
                *contact_lines(one),
            ],
            task_lines(one.tasks, style),
            cycle_lines(one.cycle, style),
            joint_lines(one.joints, style),
            drive_lines(one.drives, style),
            accuracy_lines(one, style),
        ]
    return [*sections, legend(summary.joints)]


def _station_title(station: StationSummary) -> str:
    facts = station.facts
    program, robot = clean(facts.program), clean(facts.title or facts.robot)
    ran = f" runs {program}" if program else ""
    return f"{clean(facts.name)}{ran}" + (f" on {robot}" if robot else "")


def _cell_lines(summary: Summary) -> list[str]:
    """Return the lines on the parts and devices of the cell."""
    parts = [f"parts        {destinations_text(summary.destinations)}"] if summary.destinations else []
    names = ["devices", *[""] * len(summary.devices)]
    return parts + [
        f"{name:<13}{device_text(one)}" for name, one in zip(names, summary.devices, strict=False)
    ]


def _title(summary: Summary, style: Style) -> list[str]:
    what = clean(summary.title)
    robot = f" on {clean(summary.robot)}" if summary.robot else ""
    if len(summary.facts.stations) > 1:
        what, robot = clean(summary.facts.project or "run"), f": {_stations(summary)}"
    state = verdict(summary)
    return [
        paint(fit(what + robot, COLUMNS), Tone.STRONG, style),
        *(["kinematic run: the arm follows its references exactly"] if summary.facts.is_kinematic else []),
        *(paint(line, _VERDICT_TONES[state.kind], style) for line in textwrap.wrap(state.text, COLUMNS)),
        *_unchecked(summary.unchecked.text),
    ]


def _stations(summary: Summary) -> str:
    """Return which station has which robot."""
    stations = ((one.name, one.title or one.robot) for one in summary.facts.stations)
    return ", ".join(clean(f"{name} on {robot}" if robot else name) for name, robot in stations)


def _unchecked(text: str) -> list[str]:
    """Return the line on omitted checks; a long one breaks between its parts."""
    glued = (part.replace(" ", "\u00a0") if len(part) < COLUMNS - 2 else part for part in text.split(" · "))
    whole = "\u00a0· ".join(glued)
    return textwrap.wrap(whole, COLUMNS, subsequent_indent="  ")


def _called(summary: Summary) -> list[str]:
    """Return which tasks of knowledge bases ran, with their versions."""
    called_tasks = (
        clean(f"{one.name} {one.version[:SHORT_VERSION]} of {one.source}") for one in summary.called
    )
    tasks = "; ".join(one.replace(" ", "\u00a0") for one in called_tasks)
    words = f"tasks of knowledge bases: {tasks}" if tasks else ""
    return textwrap.wrap(words, COLUMNS, subsequent_indent="  ")


def _findings(summary: Summary, style: Style) -> list[str]:
    lines = [line for group in summary.findings[:SHOWN_FINDINGS] for line in _finding(group, style)]
    return [*lines, *more(len(summary.findings) - SHOWN_FINDINGS, "finding")]


def _finding(group: FindingGroup, style: Style) -> Iterable[str]:
    first = group.first
    code = f"{first.severity.value}[{first.code}]"
    repeats = f"{group.count} × " if group.count > 1 else ""
    place = f"{clean(str(first.span))}: " if first.span else ""
    text = f"{code} {repeats}{place}{clean(first.message)}"
    if group.count > 1 and group.where:
        text += f" ({clean(group.where)})"
    text += f" – {group.cause_text}" if group.cause_text else ""
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
