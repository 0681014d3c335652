"""Charts over frequency as SVG: rows that share one logarithmic axis."""

import math

import numpy as np

from ropsim.spatial import Array, record
from ropsim.views.chart.axes import LEFT, RIGHT, WIDTH, Frame
from ropsim.views.chart.chart import AXIS, GAP, TOP, TraceRow, frame_of, row_of_traces
from ropsim.views.markup.markup import coordinate, text

_STEPS = (1.0, 2.0, 5.0)


@record
class FrequencyChart:
    """Rows over one axis of frequencies.

    Attributes:
        ident: unique name inside the page.
        title: for readers who cannot see the picture.
        description: content of the picture, in a sentence.
        hz: frequencies [Hz], rising, at least two, shape (n,).
        rows: from top to bottom.
    """

    ident: str
    title: str
    description: str
    hz: Array
    rows: tuple[TraceRow, ...]


def frequency_chart(chart: FrequencyChart) -> str:
    """Return the chart as an SVG element with title and description."""
    places = np.log10(chart.hz / chart.hz[0])
    end, top, parts = float(places[-1]), TOP, []
    for row in chart.rows:
        parts.append(row_of_traces(row, frame_of(row, end, top), places))
        top += row.height + GAP
    bottom = top - GAP
    parts.append(_axis(float(chart.hz[0]), float(chart.hz[-1]), bottom))
    return (
        f'<svg class="frequency" viewBox="0 0 {WIDTH:g} {coordinate(bottom + AXIS)}" role="img"'
        f' aria-labelledby="{chart.ident}-t {chart.ident}-d">\n'
        f'<title id="{chart.ident}-t">{text(chart.title)}</title>\n'
        f'<desc id="{chart.ident}-d">{text(chart.description)}</desc>\n{"".join(parts)}</svg>\n'
    )


def frequency_ticks(low: float, high: float) -> tuple[float, ...]:
    """Return 1, 2 and 5 times the powers of ten from one frequency to another [Hz]."""
    powers = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    ticks = (step * 10.0**power for power in powers for step in _STEPS)
    return tuple(tick for tick in ticks if low * (1.0 - 1e-9) <= tick <= high * (1.0 + 1e-9))


def _axis(low: float, high: float, bottom: float) -> str:
    frame, marks = Frame(math.log10(high / low), 0.0, 1.0), []
    for tick in frequency_ticks(low, high):
        x = coordinate(frame.x(math.log10(tick / low)))
        marks.append(
            f'<line class="mark" x1="{x}" x2="{x}" y1="{coordinate(bottom)}" y2="{coordinate(bottom + 4)}"/>'
            f'<text class="middle tick" x="{x}" y="{coordinate(bottom + 16)}">{tick:g}</text>'
        )
    y = coordinate(bottom)
    return (
        f'<g><line class="mark" x1="{LEFT:g}" x2="{RIGHT:g}" y1="{y}" y2="{y}"/>{"".join(marks)}'
        f'<text class="tick" x="{RIGHT + 22:g}" y="{coordinate(bottom + 16)}">Hz</text></g>\n'
    )
