"""How true a run or a station was to its commands, as lines for a terminal of 80 columns."""

import math

from ropsim.core import plural
from ropsim.flow import SpeedCause
from ropsim.views.accuracy import BAND, ContourFigures, CornerFigures, StopFigures
from ropsim.views.summary.findings import place_text
from ropsim.views.summary.path_summary import PathMove, PathSummary
from ropsim.views.summary.station_summary import Figures
from ropsim.views.terminal.columns import Style, TableCell, Tone, columns_text, paint
from ropsim.views.words.characters import clean, fit
from ropsim.views.words.contours import contour_name
from ropsim.views.words.figures import (
    DEGREES,
    MILLIMETRES,
    MILLIMETRES_PER_SECOND,
    PERCENT,
    UNKNOWN,
    WITHOUT_DRIVES,
    fixed,
    seconds,
    with_unit,
)

_SHOWN_CONTOURS = 6
_NAME = 30
"""Columns for the name of a contour."""
_OFF = 1e-3
"""Distance from its target beyond which it is said of a stop that is reached [m]."""


def accuracy_lines(figures: Figures, style: Style) -> list[str]:
    """Return the accuracy of paths, corners and stops; without sections that the run does not have."""
    if not figures.is_driven:
        return [*_commanded(figures.path, style), *_planned(figures.corners, style)]
    return [
        *_path(figures.path, figures.contours, style),
        *_contours(figures.contours, style),
        *_corners(figures.corners, style),
        *_stops(figures.stops, style),
        *conditions_lines(figures, style),
    ]


def conditions_lines(figures: Figures, style: Style) -> list[str]:
    """Return under which conditions the figures hold; none without figures of paths, corners or stops."""
    if figures.path.worst is None and not figures.corners and not figures.stops:
        return []
    found = figures.path.conditions
    speeds = dict.fromkeys(
        with_unit(one, MILLIMETRES_PER_SECOND, 0)
        for one in (found.least_speed, found.most_speed)
        if math.isfinite(one)
    )
    passes = [f"at most {found.cycles} pass{'es' if found.cycles > 1 else ''} of one"] if found.cycles else []
    given = [f"  given speed: {' to '.join(speeds)}"] if speeds else []
    return [
        paint("conditions of the accuracy", Tone.QUIET, style),
        f"  {', '.join(['paths and stops of the program', *passes])}",
        *given,
        f"  load: {found.load}",
        f"  not in it: {', '.join(found.left_out[:3])}; no test after ISO 9283",
    ]


def _commanded(path: PathSummary, style: Style) -> list[str]:
    """Return the lines on tool paths of an arm without drives."""
    if not path.moves:
        return []
    title = paint(f"path error of tool paths ({plural(len(path.moves), 'move')})", Tone.QUIET, style)
    return [f"{title}: {WITHOUT_DRIVES}", *slow_lines(path)]


def _planned(corners: tuple[CornerFigures, ...], style: Style) -> list[str]:
    """Return the lines on blends of an arm without drives."""
    if not corners:
        return []
    title = paint(f"rounded corners ({len(corners)})", Tone.QUIET, style)
    return [f"{title}: {WITHOUT_DRIVES}; planned {_ends([one.planned for one in corners])} from the corner"]


def _path(path: PathSummary, contours: tuple[ContourFigures, ...], style: Style) -> list[str]:
    worst = path.worst
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
    return [
        paint(f"path error of tool paths ({plural(len(path.moves), 'move')})", Tone.QUIET, style),
        f"  {figures}",
        f"  worst at t = {seconds(worst.time)} s{place_text(worst.line, worst.visit)}",
        *_against(contours),
        *_orientation(path),
        *_repeats(path),
        *slow_lines(path),
        *_speeds(path),
    ]


def _against(contours: tuple[ContourFigures, ...]) -> list[str]:
    """Return what the figures above compare, where contours have others."""
    if not contours:
        return []
    whole = with_unit(max(one.path_max for one in contours), MILLIMETRES, 3)
    return [f"  each move against its own part of the path; contours as a whole: max {whole}"]


def _contours(contours: tuple[ContourFigures, ...], style: Style) -> list[str]:
    """Return the table of the contours with the largest path errors, in order of time."""
    if not contours:
        return []
    worst = sorted(contours, key=lambda one: -one.path_max)[:_SHOWN_CONTOURS]
    rows = [
        tuple(
            map(
                TableCell,
                (
                    f"  {fit(contour_name(one), _NAME)}",
                    *(
                        fixed(value, MILLIMETRES, 3)
                        for value in (
                            one.path_max,
                            one.path_mean,
                            one.tracking_max,
                            one.tracking_end,
                            one.overshoot,
                        )
                    ),
                ),
            )
        )
        for one in contours
        if one in worst
    ]
    title = f"contours ({len(contours)}), errors in mm"
    header = ("", "path\nmax", "\nmean", "in time\nmax", "\nat its end", "beyond\nstops")
    left = len(contours) - len(rows)
    more = [f"  and {left} more with smaller path errors"] if left else []
    return [paint(title, Tone.QUIET, style), *columns_text(header, rows, style), *more]


def _orientation(path: PathSummary) -> list[str]:
    worst = path.worst_angle
    if worst is None:
        return []
    return [
        f"  orientation: max {with_unit(worst.max_angle, DEGREES, 3)}{place_text(worst.line, worst.visit)}"
    ]


def _repeats(path: PathSummary) -> list[str]:
    line = path.worst_repeat
    if line is None:
        return []
    passes = f"{len(line.moves)} passes of line {line.line}" if line.line else f"{len(line.moves)} passes"
    return [f"  spread of the passes: max {with_unit(line.repeatability, MILLIMETRES, 3)} ({passes})"]


def slow_lines(path: PathSummary) -> list[str]:
    """Return the lines on moves that do not come to their given speed; none where all do."""
    if not path.slow:
        return []
    least = min(path.slow, key=lambda move: move.speeds.command / move.given)
    speeds = f"{with_unit(least.speeds.command, MILLIMETRES_PER_SECOND, 0)} of " + with_unit(
        least.given, MILLIMETRES_PER_SECOND, 0
    )
    many = plural(len(path.slow), "move")
    why = limited_by(least)
    return [
        f"  given speed not reached in {many}: {speeds}{place_text(least.line, least.visit)}",
        *([f"    limited by {why}"] if why else []),
        *_lost(path),
    ]


def _lost(path: PathSummary) -> list[str]:
    """Return the line on the time that moves lose against the given speed, and where most of it is lost."""
    lost = math.fsum(move.reached.lost for move in path.moves if move.reached)
    if not lost > 0.0:
        return []
    most = max(path.moves, key=lambda move: move.reached.lost if move.reached else 0.0)
    where = f"{place_text(most.line, most.visit)}, {limited_by(most)}"
    return [f"  time lost against it: {seconds(lost)} s; most{where}"]


def limited_by(move: PathMove) -> str:
    """Return what keeps a move below its given speed, or sets its time where it falls short; else nothing."""
    reached, critical = move.reached, move.critical
    if reached and reached.cause is SpeedCause.JOINT:
        near = f", {reached.singularity} singular" if reached.singularity else ""
        quantity = f" {reached.quantity.value}" if reached.quantity else ""
        return f"joint {clean(reached.joint)}{quantity}{near}"
    if reached:
        return reached.cause.value
    if not move.falls_short or critical is None:
        return ""
    return f"{f'joint {clean(critical.joint)}' if critical.joint else 'path'} {critical.quantity.value}"


def _speeds(path: PathSummary) -> list[str]:
    worst = path.worst_speed
    if worst is None:
        return []
    speeds, place = worst.speeds, place_text(worst.line, worst.visit)
    wanted = with_unit(speeds.command, MILLIMETRES_PER_SECOND, 0)
    return [
        f"  speed error: mean {_signed(path.mean_speed_accuracy)}",
        f"  worst {_signed(speeds.accuracy)} of {wanted}{place}",
        f"  speed fluctuation: max {with_unit(path.largest_fluctuation, MILLIMETRES_PER_SECOND, 2)}",
    ]


def _corners(corners: tuple[CornerFigures, ...], style: Style) -> list[str]:
    if not corners:
        return []
    nearest, farthest = (pick(corners, key=lambda one: one.rounding) for pick in (min, max))
    beyond = max(corners, key=lambda one: one.overshoot if math.isfinite(one.overshoot) else -1.0)
    away = _ends([nearest.rounding, farthest.rounding])
    lines = [
        paint(f"rounded corners ({len(corners)})", Tone.QUIET, style),
        f"  corner rounding: {away}{place_text(farthest.line, farthest.visit)}",
    ]
    if math.isfinite(beyond.overshoot):
        most = with_unit(beyond.overshoot, MILLIMETRES, 3)
        lines.append(f"  overshoot behind corners: max {most}{place_text(beyond.line, beyond.visit)}")
    return lines


def _stops(stops: tuple[StopFigures, ...], style: Style) -> list[str]:
    if not stops:
        return []
    title = paint(f"stops ({len(stops)})", Tone.QUIET, style)
    return [title, *_ends_of(stops, style), *_overshoot(stops), *_stabilization(stops)]


def _ends_of(stops: tuple[StopFigures, ...], style: Style) -> list[str]:
    """Return how far stops end from their targets, and how many of them are not reached."""
    missed = [one for one in stops if not one.is_reached]
    far = max(missed or stops, key=lambda one: one.away)
    away = f"{with_unit(far.away, MILLIMETRES, 3)}{place_text(far.line, far.visit)}"
    if missed:
        return [paint(f"  ! not reached: {len(missed)} of {len(stops)}, farthest {away}", Tone.ERROR, style)]
    return [f"  distance from the target at the end: max {away}"] if far.away > _OFF else []


def _overshoot(stops: tuple[StopFigures, ...]) -> list[str]:
    known = [one for one in stops if math.isfinite(one.overshoot)]
    if not known:
        return [f"  overshoot at stops: {UNKNOWN}, the TCP comes to no target"]
    far = max(known, key=lambda one: one.overshoot)
    if not far.overshoot > 0.0:
        return [f"  overshoot at stops: none beyond {with_unit(BAND, MILLIMETRES, 1)}"]
    over = f"{with_unit(far.overshoot, MILLIMETRES, 3)}{place_text(far.line, far.visit)}"
    return [f"  overshoot at stops: max {over}"]


def _stabilization(stops: tuple[StopFigures, ...]) -> list[str]:
    """Return how long the TCP takes until it stays at its place; nothing where it never goes beyond it."""
    if not any(one.overshoot > 0.0 or not one.is_reached for one in stops):
        return []
    band = with_unit(BAND, MILLIMETRES, 1)
    known = [one for one in stops if math.isfinite(one.stabilization)]
    lines, restless = [], len(stops) - len(known)
    slow = max(known, key=lambda one: one.stabilization, default=None)
    if slow is not None and slow.stabilization > 0.0:
        lines.append(
            f"  time to stay at its place: max {slow.stabilization:.3f} s{place_text(slow.line, slow.visit)}"
        )
    if restless:
        lines.append(f"  not within {band} of its place when it went on: {plural(restless, 'stop')}")
    return lines


def _ends(lengths: list[float]) -> str:
    """Return the least and the largest of some lengths [m], one where they read the same."""
    return " to ".join(dict.fromkeys(with_unit(one, MILLIMETRES, 3) for one in (min(lengths), max(lengths))))


def _signed(share: float) -> str:
    text = with_unit(share, PERCENT, 2)
    return text if not math.isfinite(share) or share < 0.0 else f"+{text}"
