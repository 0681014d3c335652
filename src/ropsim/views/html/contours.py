"""Contours in the HTML report: a table, and each in its plane with the error enlarged."""

from ropsim.flow import Recording
from ropsim.views.accuracy import ContourFigures, ContourRows
from ropsim.views.accuracy.contour_drawing import contour_drawing
from ropsim.views.chart.plane import ContourChart, contour_chart
from ropsim.views.html.strips import figure
from ropsim.views.markup.markup import table, text
from ropsim.views.summary.station_summary import StationSummary, drawn_contours
from ropsim.views.words.contours import contour_name
from ropsim.views.words.figures import MILLIMETRES, fixed, seconds


def contour_section(station: StationSummary, recording: Recording, of: str) -> str:
    """Return the section on the contours of a station; nothing where it has none.

    Args:
        station: the station.
        recording: of the run.
        of: suffix of its title, such as ` of left`.
    """
    if not station.contours:
        return ""
    kept = drawn_contours(recording, station)
    several = len(recording.facts.stations) > 1
    suffix = f"-{[one.name for one in recording.facts.stations].index(station.facts.name)}" if several else ""
    charts = "".join(_chart(one, rows, f"{number}{suffix}") for number, (one, rows) in enumerate(kept, 1))
    is_part = len(station.contours) > len(kept)
    left_out = f"<p>The {len(kept)} with the largest errors are drawn.</p>\n" if is_part else ""
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
    drawing = contour_drawing(one, rows)
    title = f"{contour_name(one)}: {drawing.words}, at most {fixed(one.path_max, MILLIMETRES, 3)} mm"
    svg = contour_chart(
        ContourChart(
            f"contour-{suffix}",
            title,
            f"Contour and attained path of the tool centre point in the base frame, {drawing.words}.",
            (f"{drawing.axes[0]} [mm]", f"{drawing.axes[1]} [mm]"),
            drawing.wanted * MILLIMETRES.factor,
            drawing.attained * MILLIMETRES.factor,
        )
    )
    return f"<div><p>{text(title)}</p>\n{svg}</div>\n"
