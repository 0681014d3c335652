"""Contours in the HTML report: a table, and each in its plane with the error enlarged."""

import numpy as np

from ropsim.flow import Recording
from ropsim.spatial import Array
from ropsim.views.accuracy import ContourFigures, ContourRows, contours
from ropsim.views.channels import station_views
from ropsim.views.chart.plane import ContourChart, contour_chart
from ropsim.views.html.strips import figure
from ropsim.views.markup.markup import table, text
from ropsim.views.summary.station_summary import StationSummary
from ropsim.views.words.contours import contour_name
from ropsim.views.words.figures import MILLIMETRES, fixed, seconds

MOST = 8
"""Contours that are drawn: those with the largest path errors."""
SHARE = 0.08
"""An error is drawn at most this share of the size of its contour long."""
_STEPS = (1, 2, 5)


def contour_section(station: StationSummary, recording: Recording, of: str) -> str:
    """Return the section on the contours of a station; nothing where it has none.

    Args:
        station: the station.
        recording: of the run.
        of: suffix of its title, such as ` of left`.
    """
    if not station.contours:
        return ""
    views = (one for one in station_views(recording) if one.facts.name == station.facts.name)
    drawn = [pair for view in views for pair in contours(view, station.stops)]
    worst = sorted(drawn, key=lambda one: -one[0].path_max)[:MOST]
    kept = [pair for pair in drawn if pair in worst]
    several = len(recording.facts.stations) > 1
    suffix = f"-{[one.name for one in recording.facts.stations].index(station.facts.name)}" if several else ""
    charts = "".join(_chart(one, rows, f"{number}{suffix}") for number, (one, rows) in enumerate(kept, 1))
    left_out = f"<p>The {MOST} with the largest errors are drawn.</p>\n" if len(drawn) > MOST else ""
    body = f'<div class="pair">{charts}</div>'
    picture = figure("Contours, errors enlarged", ("contour", "way"), body)
    return f"<section><h2>Contours{of}</h2>\n{_table(station.contours)}{left_out}{picture}</section>\n"


def _table(found: tuple[ContourFigures, ...]) -> str:
    header = (
        "contour",
        "moves",
        "from [s]",
        "path error<br>max [mm]",
        "at t [s]",
        "mean<br>[mm]",
        "error in time<br>max [mm]",
        "at its end<br>[mm]",
        "beyond stops<br>max [mm]",
    )
    rows = [
        (
            text(contour_name(one)),
            str(one.moves),
            seconds(one.start),
            fixed(one.path_max, MILLIMETRES, 3),
            seconds(one.time),
            fixed(one.path_mean, MILLIMETRES, 3),
            fixed(one.tracking_max, MILLIMETRES, 3),
            fixed(one.tracking_end, MILLIMETRES, 3),
            fixed(one.overshoot, MILLIMETRES, 3),
        )
        for one in found
    ]
    caption = (
        "Tool paths that follow upon each other. Path error: distance from the contour as a whole; error in "
        "time: distance from where the tool centre point is commanded at that moment, and that when the "
        "command arrives."
    )
    return table(caption, header, rows)


def _chart(one: ContourFigures, rows: ContourRows, suffix: str) -> str:
    size = float(np.ptp(rows.corners, axis=0).max())
    factor = _factor(SHARE * size / one.path_max if one.path_max > 0.0 else 1.0)
    drawn = rows.nearest + factor * (rows.attained - rows.nearest)
    first, second = _plane(rows.corners)
    plane = [first, second]
    enlarged = f"error × {factor}" if factor > 1 else "true to scale"
    title = f"{contour_name(one)}: {enlarged}, at most {fixed(one.path_max, MILLIMETRES, 3)} mm"
    svg = contour_chart(
        ContourChart(
            f"contour-{suffix}",
            title,
            f"Contour and attained path of the tool centre point in the base frame, {enlarged}.",
            (f"{'xyz'[first]} [mm]", f"{'xyz'[second]} [mm]"),
            rows.corners[:, plane] * MILLIMETRES.factor,
            drawn[:, plane] * MILLIMETRES.factor,
        )
    )
    return f"<div><p>{text(title)}</p>\n{svg}</div>\n"


def _factor(most: float) -> int:
    """Return the largest of 1, 2, 5, 10, 20 … that is not above a number; 1 at least."""
    power = 10 ** int(np.floor(np.log10(max(most, 1.0))))
    return int(max(step * power for step in _STEPS if step * power <= max(most, 1.0)))


def _plane(corners: Array) -> tuple[int, int]:
    """Return the axes of the plane that shows most of a contour: all but the one along which it is least."""
    extents = np.ptp(corners, axis=0)
    first, second = sorted(np.argsort(-extents, kind="stable")[:2].tolist())
    return first, second
