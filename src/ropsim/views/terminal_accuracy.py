"""How true a run or a station was to its commands, as lines for a terminal of 80 columns."""

import math

from ropsim.core import plural
from ropsim.views.accuracy import BAND, CornerFigures, StopFigures
from ropsim.views.figures import (
    DEGREES,
    MILLIMETRES,
    MILLIMETRES_PER_SECOND,
    PERCENT,
    seconds,
    with_unit,
)
from ropsim.views.findings import place_text
from ropsim.views.path_summary import PathSummary
from ropsim.views.station_summary import Figures
from ropsim.views.style import Style, Tone, paint


def accuracy_lines(figures: Figures, style: Style) -> list[str]:
    """Return the accuracy of paths, corners and stops; nothing of what the run does not have."""
    return [
        *_path(figures.path, style),
        *_corners(figures.corners, style),
        *_stops(figures.stops, style),
    ]


def _path(path: PathSummary, style: Style) -> list[str]:
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
        *_orientation(path),
        *_repeats(path),
        *_slow(path),
        *_speeds(path),
    ]


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
    return [f"  path repeatability RT: max {with_unit(line.repeatability, MILLIMETRES, 3)} ({passes})"]


def _slow(path: PathSummary) -> list[str]:
    if not path.slow:
        return []
    least = min(path.slow, key=lambda move: move.speeds.command / move.given)
    speeds = f"{with_unit(least.speeds.command, MILLIMETRES_PER_SECOND, 0)} of " + with_unit(
        least.given, MILLIMETRES_PER_SECOND, 0
    )
    many = plural(len(path.slow), "move")
    return [f"  given speed not reached in {many}: {speeds}{place_text(least.line, least.visit)}"]


def _speeds(path: PathSummary) -> list[str]:
    worst = path.worst_speed
    if worst is None:
        return []
    speeds, place = worst.speeds, place_text(worst.line, worst.visit)
    wanted = with_unit(speeds.command, MILLIMETRES_PER_SECOND, 0)
    return [
        f"  path velocity accuracy AV: mean {_signed(path.mean_speed_accuracy)}",
        f"  worst {_signed(speeds.accuracy)} of {wanted}{place}",
        f"  fluctuation FV: max {with_unit(path.largest_fluctuation, MILLIMETRES_PER_SECOND, 2)}",
    ]


def _corners(corners: tuple[CornerFigures, ...], style: Style) -> list[str]:
    if not corners:
        return []
    nearest, farthest = (pick(corners, key=lambda one: one.rounding) for pick in (min, max))
    beyond = max(corners, key=lambda one: one.overshoot if math.isfinite(one.overshoot) else -1.0)
    ends = (with_unit(one.rounding, MILLIMETRES, 3) for one in (nearest, farthest))
    away = " to ".join(dict.fromkeys(ends))
    lines = [
        paint(f"rounded corners ({len(corners)})", Tone.QUIET, style),
        f"  corner rounding CR: {away}{place_text(farthest.line, farthest.visit)}",
    ]
    if math.isfinite(beyond.overshoot):
        most = with_unit(beyond.overshoot, MILLIMETRES, 3)
        lines.append(f"  cornering overshoot CO: max {most}{place_text(beyond.line, beyond.visit)}")
    return lines


def _stops(stops: tuple[StopFigures, ...], style: Style) -> list[str]:
    if not stops:
        return []
    title = paint(f"stops ({len(stops)})", Tone.QUIET, style)
    slow = max(stops, key=lambda one: one.stabilization)
    far = max(stops, key=lambda one: one.overshoot)
    if not far.overshoot > 0.0:
        return [title, f"  position overshoot OV: none beyond {with_unit(BAND, MILLIMETRES, 1)}"]
    band = with_unit(BAND, MILLIMETRES, 1)
    over = f"{with_unit(far.overshoot, MILLIMETRES, 3)}{place_text(far.line, far.visit)}"
    longest = f"max {slow.stabilization:.3f} s{place_text(slow.line, slow.visit)}"
    return [
        title,
        f"  position overshoot OV: max {over}",
        f"  stabilization time, from first coming within {band} of its rest until the TCP stays: {longest}",
    ]


def _signed(share: float) -> str:
    text = with_unit(share, PERCENT, 2)
    return text if not math.isfinite(share) or share < 0.0 else f"+{text}"
