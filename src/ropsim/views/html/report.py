"""The report of a run as one HTML page that needs nothing else: no network, no other file."""

import base64
import hashlib
import math
from collections.abc import Mapping

from ropsim.core import SourceText, plural
from ropsim.flow import IntegrationFacts, Recording, StationFacts
from ropsim.views.comparison import Comparison, comparison_section
from ropsim.views.html.accuracy import accuracy_section
from ropsim.views.html.cards import key_figures, station_figures
from ropsim.views.html.charts import active_lines, figures
from ropsim.views.html.contours import contour_section
from ropsim.views.html.cursor import SCRIPT
from ropsim.views.html.cycle import cycle_section
from ropsim.views.html.definitions import DEFINITIONS
from ropsim.views.html.energy import drive_section, energy_section
from ropsim.views.html.findings import findings_section, messages_section, skipped_section
from ropsim.views.html.replay import (
    NoReplay,
    Replay,
    inline_script,
    inline_style,
    replay_data,
    replay_section,
)
from ropsim.views.html.tables import approach_table, called_table, joint_table, origin_table, task_table
from ropsim.views.markup.markup import text
from ropsim.views.markup.theme import stylesheet
from ropsim.views.summary.station_summary import StationSummary
from ropsim.views.summary.summary import Summary
from ropsim.views.summary.verdict import Verdict, verdict
from ropsim.views.ways import ways_section
from ropsim.views.words.figures import digits, seconds
from ropsim.views.words.messages import messages

SHOWN_LINE_CHANGES = 5000

_SIGNS = {Verdict.GOOD: "✓", Verdict.DOUBTFUL: "!", Verdict.FAILED: "✕"}


def html_report(
    recording: Recording,
    summary: Summary,
    sources: Mapping[str, SourceText],
    replay: Replay | NoReplay | None = None,
    comparison: Comparison | None = None,
) -> str:
    """Return the page.

    Args:
        recording: of the run.
        summary: its figures, from `summarize`.
        sources: program texts by the names that spans use, for quoting; may be empty.
        replay: of the run in 3-D, or why there is none; None says nothing about it.
        comparison: with runs in which something is changed; None for none.
    """
    name = summary.title
    shown = replay if isinstance(replay, Replay) else None
    body = [
        _header(name, summary),
        replay_section(replay),
        key_figures(summary),
        findings_section(summary, sources),
        skipped_section(summary),
        ways_section(summary.facts),
        messages_section(messages(recording)),
        comparison_section(comparison),
        *(_station(one, recording, summary, sources) for one in summary.stations),
        _charts(recording, summary),
        _called(summary),
        _origins(summary),
        _definitions(),
        _footer(summary),
    ]
    scripts = [SCRIPT, inline_script(shown.script)] if shown else [SCRIPT]
    style = stylesheet() + (inline_style(shown.style) if shown else "")
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f"<title>{text(name)} – run report</title>\n"
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_policy(scripts)}">\n'
        f"<style>\n{style}</style>\n</head>\n<body>\n<main>\n{''.join(body)}</main>\n"
        f"{_reading(recording)}{replay_data(shown) if shown else ''}"
        f"{''.join(f'<script>{script}</script>' for script in scripts)}\n</body>\n</html>\n"
    )


def _policy(scripts: list[str]) -> str:
    """Return the content policy: these scripts and no others, pictures made by them, no network."""
    digests = [base64.b64encode(hashlib.sha256(one.encode()).digest()).decode("ascii") for one in scripts]
    allowed = " ".join(f"&#39;sha256-{digest}&#39;" for digest in digests)
    return (
        "default-src &#39;none&#39;; style-src &#39;unsafe-inline&#39;; img-src data: blob:; "
        f"script-src {allowed}"
    )


def _header(name: str, summary: Summary) -> str:
    state = verdict(summary)
    robot = f'<p class="quiet">{text(summary.robot)}</p>' if summary.robot else ""
    kinematic = (
        "<p>Kinematic run: the arm follows its references exactly.</p>" if summary.facts.is_kinematic else ""
    )
    left_open = text(summary.unchecked.text)
    unchecked = f'<p class="unchecked">{left_open}</p>\n' if left_open else ""
    return (
        f"<header>\n<h1>{text(name)}</h1>\n{robot}{kinematic}"
        f'<p class="verdict {state.kind.value}"><span aria-hidden="true">{_SIGNS[state.kind]} </span>'
        f"{text(state.text)}</p>\n"
        f"{unchecked}</header>\n"
    )


def _station(
    station: StationSummary, recording: Recording, summary: Summary, sources: Mapping[str, SourceText]
) -> str:
    """Return the tables of a station, headed by its name and key figures where there are several."""
    parts, facts, of = [], station.facts, ""
    if len(summary.stations) > 1:
        of = f" of {text(facts.name)}"
        parts += [_station_header(facts), station_figures(station, summary)]
    if station.joints:
        parts.append(
            f"<section><h2>Joints{of}</h2>\n{joint_table(station.joints)}<h3>Limits</h3>\n"
            f"{approach_table(station.joints)}</section>\n"
        )
    if station.tasks:
        tasks = task_table(station.tasks, station.cycle_time)
        parts.append(f"<section><h2>Tasks{of}</h2>\n{tasks}</section>\n")
    parts.append(cycle_section(station.cycle, sources.get(facts.source), of))
    parts.append(energy_section(station.energy, sources.get(facts.source), of))
    parts.append(drive_section(station.drives, of))
    parts.append(accuracy_section(station, of, sources.get(facts.source)))
    parts.append(contour_section(station, recording, of))
    return "".join(parts)


def _station_header(facts: StationFacts) -> str:
    what = " on ".join(text(one) for one in (facts.program, facts.title or facts.robot) if one)
    return f'<section><h2>Station {text(facts.name)}</h2>\n<p class="quiet">{what}</p></section>\n'


def _charts(recording: Recording, summary: Summary) -> str:
    drawn = figures(recording, summary)
    if not drawn:
        return ""
    how = "Point at a chart to read all values at one time, or focus it and use the arrow keys, Home and End."
    return f'<section><h2>Charts</h2>\n<p class="quiet screen">{how}</p>\n{"".join(drawn)}</section>\n'


def _called(summary: Summary) -> str:
    """Return the tasks of knowledge bases that ran; nothing where none did."""
    if not summary.called:
        return ""
    return f"<section><h2>Tasks of knowledge bases</h2>\n{called_table(summary)}</section>\n"


def _origins(summary: Summary) -> str:
    if not summary.unchecked.estimated and not summary.origins:
        return ""
    entries = "".join(f"<li>{text(entry)}</li>" for entry in summary.unchecked.estimated)
    estimated = f"<p>Estimated, not from a published source:</p><ul>{entries}</ul>" if entries else ""
    origins = origin_table(summary) if summary.origins else ""
    return f"<section><h2>Where the numbers come from</h2>\n{estimated}{origins}</section>\n"


def _definitions() -> str:
    words = "".join(f"<dt>{word}</dt><dd>{meaning}</dd>\n" for word, meaning in DEFINITIONS.items())
    return f'<section><h2>How the figures are defined</h2>\n<dl class="words">{words}</dl></section>\n'


def _footer(summary: Summary) -> str:
    facts, stations = summary.facts, summary.facts.stations
    parts = [f"ropsim {facts.ropsim}".strip(), f"simulated {seconds(summary.duration)} s"]
    rates = dict.fromkeys(f"{one.control_hz:g} Hz" for one in stations if math.isfinite(one.control_hz))
    if rates:
        parts.append(f"control {', '.join(rates)}")
    ways = (_integration(one.plant_steps, one.integration) for one in stations if one.integration)
    parts += dict.fromkeys(ways) if not facts.is_kinematic else ["kinematic: nothing is integrated"]
    if math.isfinite(facts.record_hz):
        parts.append(f"recorded at {facts.record_hz:g} Hz")
    parts += [f"program id {one.icr_id}" for one in stations if one.icr_id]
    return f"<footer>{text(' · '.join(parts))}</footer>\n"


def _integration(steps: int, way: IntegrationFacts) -> str:
    """Return how drives and arm were integrated."""
    how = f"{way.method} in steps of {digits(way.step * 1e3)} ms, {plural(steps, 'step')} per control tick"
    why = f"set by: {way.cause.value}; fastest pole {digits(way.pole)} 1/s"
    error = f", error at most {way.error:.0e} rad or m" if math.isfinite(way.error) else ""
    return f"{how} ({why}){error}"


def _reading(recording: Recording) -> str:
    """Return the box of the time cursor, with the source line active at each time."""
    starts, lines = active_lines(recording)
    if len(starts) > SHOWN_LINE_CHANGES:
        starts, lines = [], []
    return (
        f'<output id="reading" data-starts="{" ".join(f"{start:.4g}" for start in starts)}"'
        f' data-lines="{" ".join(map(str, lines))}"></output>\n'
    )
