"""Tables of the HTML report on how true the arm was to its commands."""

import math
from collections.abc import Sequence
from typing import TypeVar

from ropsim.core import SourceText
from ropsim.views.accuracy import CYCLES, CornerFigures, StopFigures
from ropsim.views.html.tables import source_cell
from ropsim.views.markup.markup import table, text
from ropsim.views.summary.path_summary import PathLine, PathMove, PathSummary
from ropsim.views.summary.station_summary import Figures
from ropsim.views.terminal.accuracy import limited_by
from ropsim.views.words.figures import (
    DEGREES,
    METRES,
    MILLIMETRES,
    MILLIMETRES_PER_SECOND,
    PERCENT,
    UNKNOWN,
    fixed,
    percent,
    seconds,
)

T = TypeVar("T", CornerFigures, StopFigures)


def accuracy_section(figures: Figures, of: str, source: SourceText | None) -> str:
    """Return the section of a station; nothing where it has neither tool paths nor corners nor stops.

    Args:
        figures: of the station.
        of: suffix of its title, such as ` of left`.
        source: text of its program, None where it is not known.
    """
    tables = (
        path_table(figures.path, source) if figures.path.lines else "",
        corner_table(figures.corners) if figures.corners else "",
        stop_table(figures.stops) if figures.stops else "",
    )
    if not any(tables):
        return ""
    note = "" if figures.is_driven else "<p>Without drives: the arm is where its reference is.</p>\n"
    if figures.is_driven:
        note = f"<p>{_conditions(figures)}</p>\n"
    return f"<section><h2>Accuracy{of}</h2>\n{note}{''.join(tables)}</section>\n"


def _conditions(figures: Figures) -> str:
    """Return the conditions of the figures in sentences."""
    found = figures.path.conditions
    speeds = dict.fromkeys(
        fixed(one, MILLIMETRES_PER_SECOND, 0)
        for one in (found.least_speed, found.most_speed)
        if math.isfinite(one)
    )
    given = f", given speed {' to '.join(speeds)} mm/s" if speeds else ""
    passes = f"; at most {found.cycles} pass{'es' if found.cycles > 1 else ''} of one" if found.cycles else ""
    return (
        f"Conditions: paths {found.paths}{given}{passes}; load: {found.load}. Not in it: "
        f"{', '.join(found.left_out)}. The formulas are those of ISO 9283:1998; this is no test after it, "
        f"which takes {CYCLES} cycles of its test path with the rated load."
    )


def path_table(path: PathSummary, source: SourceText | None) -> str:
    """Return the accuracy of tool paths per source line.

    Args:
        path: of a station.
        source: text of its program, None where it is not known.
    """
    header = (
        "line",
        "moves",
        "path error<br>max [mm]",
        "RMS<br>[mm]",
        "worst<br>pass",
        "at t [s]",
        "angle<br>max [°]",
        "spread of<br>passes [mm]",
        "command speed,<br>given [mm/s]",
        "limited by",
        "lost<br>[s]",
        "speed error<br>worst [%]",
        "fluctuation<br>max [mm/s]",
        "source",
    )
    rows = [_path_row(line, source) for line in path.lines]
    return table(
        "Distance of the attained TCP from the path of the tool (lines, arcs, curves and the corners between "
        "them) by source line.",
        header,
        rows,
    )


def corner_table(corners: Sequence[CornerFigures]) -> str:
    """Return how rounded corners are passed: of each source line the least and the largest of each figure."""
    header = (
        "line",
        "passes",
        "zone<br>[mm]",
        "planned<br>[mm]",
        "attained<br>[mm]",
        "overshoot<br>max [mm]",
        "overshoot<br>max at t [s]",
    )
    rows = []
    for line, passes in _by_line(corners):
        worst = max(passes, key=lambda one: _largest(one.overshoot))
        rows.append(
            (
                _line(line),
                str(len(passes)),
                _range([one.zone for one in passes], 1),
                _range([one.planned for one in passes], 3),
                _range([one.rounding for one in passes], 3),
                fixed(worst.overshoot, MILLIMETRES, 3),
                seconds(worst.time) if math.isfinite(worst.overshoot) else UNKNOWN,
            )
        )
    return table(
        "Rounded corners by source line: least distance from the corner point, commanded and attained, "
        "and overshoot behind it; from the least to the largest where passes differ.",
        header,
        rows,
    )


def stop_table(stops: Sequence[StopFigures]) -> str:
    """Return how moves come to rest: of each source line the largest of each figure."""
    missed = any(not one.is_reached for one in stops)
    header = (
        "line",
        "passes",
        "overshoot<br>max [mm]",
        "overshoot<br>max at t [s]",
        "to stay at<br>its place max [s]",
        "to stay at its<br>place max at t [s]",
        *(["not reached,<br>away max [mm]"] if missed else ()),
    )
    rows = []
    for line, passes in _by_line(stops):
        far = max(passes, key=lambda one: _largest(one.overshoot))
        slow = max(passes, key=lambda one: _largest(one.stabilization))
        rows.append(
            (
                _line(line),
                str(len(passes)),
                fixed(far.overshoot, MILLIMETRES, 3),
                seconds(far.time),
                fixed(slow.stabilization, METRES, 3),
                seconds(slow.time),
                *([_missed(passes)] if missed else ()),
            )
        )
    return table(
        "Stops by source line: overshoot, and time from the first coming to the place of rest until the arm "
        "stays within 0.1 mm of it; each with the pass in which it is largest.",
        header,
        rows,
    )


def _missed(passes: Sequence[StopFigures]) -> str:
    """Return in how many passes a stop is not reached, and how far from its target the worst one ends."""
    away = [one.away for one in passes if not one.is_reached]
    if not away:
        return ""
    return f'<span class="mark">{len(away)}: {fixed(max(away), MILLIMETRES, 3)}</span>'


def _largest(value: float) -> float:
    """Return a figure for comparing; one that is not known is less than all others."""
    return value if math.isfinite(value) else -1.0


def _by_line(found: Sequence[T]) -> list[tuple[int, list[T]]]:
    """Return the figures of each source line, line after line."""
    lines: dict[int, list[T]] = {}
    for one in found:
        lines.setdefault(one.line, []).append(one)
    return sorted(lines.items())


def _range(lengths: Sequence[float], digits: int) -> str:
    """Return the least and the largest of some lengths [m] in millimetres, one where they read the same."""
    ends = (fixed(end, MILLIMETRES, digits) for end in (min(lengths), max(lengths)))
    return " to ".join(dict.fromkeys(ends))


def _path_row(line: PathLine, source: SourceText | None) -> tuple[str, ...]:
    worst, speeds = line.worst, line.worst_speed.speeds if line.worst_speed else None
    angles = [move.max_angle for move in line.moves if math.isfinite(move.max_angle)]
    fluctuations = [one.speeds.fluctuation for one in line.moves if math.isfinite(one.speeds.fluctuation)]
    return (
        _line(line.line),
        str(len(line.moves)),
        fixed(worst.max_error, MILLIMETRES, 3),
        fixed(line.rms_error, MILLIMETRES, 3),
        str(worst.visit) if worst.visit else UNKNOWN,
        seconds(worst.time) if math.isfinite(worst.max_error) else UNKNOWN,
        fixed(max(angles, default=math.nan), DEGREES, 3),
        fixed(line.repeatability, MILLIMETRES, 3),
        _speed(line.slowest),
        text(limited_by(line.slowest)),
        _lost(line),
        fixed(speeds.accuracy if speeds else math.nan, PERCENT, 2),
        fixed(max(fluctuations, default=math.nan), MILLIMETRES_PER_SECOND, 2),
        source_cell(source, line.line),
    )


def _speed(move: PathMove) -> str:
    """Return the command speed of a move, the one that is given for it, and the share that is reached."""
    command, given = move.speeds.command, move.given
    shown = fixed(command, MILLIMETRES_PER_SECOND, 0)
    if not math.isfinite(given):
        return shown
    share = f", {percent(command / given)}" if math.isfinite(command) and given > 0.0 else ""
    return f"{shown} of {fixed(given, MILLIMETRES_PER_SECOND, 0)}{share}"


def _lost(line: PathLine) -> str:
    """Return the time that all passes of a line lose against the given speed; empty for none."""
    lost = math.fsum(move.reached.lost for move in line.moves if move.reached)
    return seconds(lost) if lost > 0.0 else ""


def _line(line: int) -> str:
    return str(line) if line else UNKNOWN
