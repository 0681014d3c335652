"""Charts over time as SVG: rows that share one time axis, so that all charts of a page line up."""

import math
from collections.abc import Sequence

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.spatial import Array, record
from ropsim.views.chart.axes import LEFT, RIGHT, WIDTH, Frame, time_axis, value_axis
from ropsim.views.markup.decimate import min_max
from ropsim.views.markup.markup import coordinate, points, text
from ropsim.views.markup.ticks import padded

TOP = 8.0
GAP = 10.0
AXIS = 34.0
POINTS = 1000
"""Samples drawn per trace at most."""

REACH = 0.3
"""A limit is drawn where the data come to this share of it; else it is named next to the row."""

Interval = tuple[float, float]


@record
class Trace:
    """One curve: values (n,) in the unit of its row and the class of its colour (`c1`, `c2`)."""

    name: str
    values: Array
    color: str = "c1"


@frozen_dataclass
class TraceRow:
    """Curves over time with their own value axis.

    Attributes:
        name: short, stands on the left.
        unit: of all values in the row.
        traces: the curves.
        limits: values that must not be passed; drawn dashed where the data come near.
        height: of the plot in SVG units.
    """

    name: str
    unit: str
    traces: tuple[Trace, ...]
    limits: tuple[float, ...] = ()
    height: float = 54.0


@frozen_dataclass
class SpanRow:
    """Stretches of time as bars, such as the activations of a task [s]."""

    name: str
    spans: Sequence[Interval]
    height: float = 16.0


@record
class TimeChart:
    """Rows over one time axis.

    Attributes:
        ident: unique name inside the page.
        title: for readers who cannot see the picture.
        description: content of the picture, in a sentence.
        time: [s], shape (n,).
        rows: from top to bottom.
        bands: ranges of time to shade [s].
    """

    ident: str
    title: str
    description: str
    time: Array
    rows: tuple[TraceRow | SpanRow, ...]
    bands: Sequence[Interval] = ()


def time_chart(chart: TimeChart) -> str:
    """Return the chart as an SVG element with title and description."""
    end = float(chart.time[-1]) if chart.time.size and chart.time[-1] > 0.0 else 1.0
    top, parts = TOP, []
    for row in chart.rows:
        frame = frame_of(row, end, top)
        parts.append(_bands(chart.bands, frame))
        parts.append(
            _spans(row, frame) if isinstance(row, SpanRow) else row_of_traces(row, frame, chart.time)
        )
        top += row.height + GAP
    bottom = top - GAP
    parts.append(time_axis(end, bottom))
    parts.append(f'<line class="cursor" y1="{TOP:g}" y2="{coordinate(bottom)}" x1="0" x2="0"/>')
    return (
        f'<svg class="time" viewBox="0 0 {WIDTH:g} {coordinate(bottom + AXIS)}" role="img" tabindex="0"'
        f' aria-labelledby="{chart.ident}-t {chart.ident}-d" data-end="{end:.6g}" data-left="{LEFT:g}"'
        f' data-right="{RIGHT:g}">\n<title id="{chart.ident}-t">{text(chart.title)}</title>\n'
        f'<desc id="{chart.ident}-d">{text(chart.description)}</desc>\n{"".join(parts)}</svg>\n'
    )


def frame_of(row: TraceRow | SpanRow, end: float, top: float) -> Frame:
    """Return the frame of a row whose horizontal axis goes from 0 to `end`, at a height on the picture."""
    if isinstance(row, SpanRow):
        return Frame(end, top, row.height)
    low, high = _range(row.traces)
    for limit in _near_limits(row):
        low, high = min(low, limit), max(high, limit)
    return Frame(end, top, row.height, *padded(low, high))


def _range(traces: tuple[Trace, ...]) -> Interval:
    known = [trace.values[np.isfinite(trace.values)] for trace in traces]
    extremes = [(float(values.min()), float(values.max())) for values in known if values.size]
    if not extremes:
        return -1.0, 1.0
    return min(low for low, _ in extremes), max(high for _, high in extremes)


def _near_limits(row: TraceRow) -> list[float]:
    """Return the limits worth drawing: limits of which the data reach a fair share."""
    low, high = _range(row.traces)
    finite = [limit for limit in row.limits if math.isfinite(limit)]
    return [limit for limit in finite if (high if limit > 0.0 else -low) >= REACH * abs(limit)]


def _bands(bands: Sequence[Interval], frame: Frame) -> str:
    size = f'y="{coordinate(frame.top)}" height="{coordinate(frame.height)}"'
    return "".join(
        f'<rect class="band" x="{coordinate(start)}" width="{coordinate(width)}" {size}/>'
        for start, width in _bars(bands, frame)
    )


def _spans(row: SpanRow, frame: Frame) -> str:
    size = f'y="{coordinate(frame.top)}" height="{coordinate(frame.height)}"'
    middle = coordinate(frame.top + frame.height / 2 + 4.0)
    bars = "".join(
        f'<rect class="bar" x="{coordinate(start)}" width="{coordinate(width)}" {size}/>'
        for start, width in _bars(row.spans, frame)
    )
    return (
        f'<g><rect class="lane" x="{LEFT:g}" width="{RIGHT - LEFT:g}" {size}/>{bars}'
        f'<text class="name" x="4" y="{middle}">{text(_short(row.name))}</text></g>\n'
    )


def _bars(intervals: Sequence[Interval], frame: Frame) -> list[Interval]:
    """Return left edge and width of bars; bars that touch on the picture are joined."""
    joined: list[list[float]] = []
    for start, end in sorted(intervals):
        x1, x2 = frame.x(max(start, 0.0)), frame.x(min(end, frame.end))
        if joined and x1 - joined[-1][1] < 0.4:
            joined[-1][1] = max(joined[-1][1], x2)
        elif x2 >= x1:
            joined.append([x1, x2])
    return [(x1, max(x2 - x1, 0.6)) for x1, x2 in joined]


def row_of_traces(row: TraceRow, frame: Frame, time: Array) -> str:
    """Return curves with their value axis as SVG; `time` are their places along the horizontal axis."""
    middle = frame.top + frame.height / 2
    parts = [f'<text class="name" x="4" y="{coordinate(middle + 4)}">{text(_short(row.name))}</text>']
    parts.append(value_axis(frame))
    for limit in _near_limits(row):
        y = coordinate(frame.y(limit))
        parts.append(f'<line class="limit" x1="{LEFT:g}" x2="{RIGHT:g}" y1="{y}" y2="{y}"/>')
    for k, trace in enumerate(row.traces):
        parts.append(_trace(trace, frame, time, middle + 4 + 13 * (k - (len(row.traces) - 1) / 2), row))
    return (
        f'<g class="row" data-top="{coordinate(frame.top)}" data-height="{frame.height:g}"'
        f' data-low="{frame.low:.6g}" data-high="{frame.high:.6g}">{"".join(parts)}</g>\n'
    )


def _trace(trace: Trace, frame: Frame, time: Array, baseline: float, row: TraceRow) -> str:
    lines = "".join(
        f'<polyline points="{points(_xs(frame, time[samples]), _ys(frame, trace.values[samples]))}"/>'
        for samples in min_max(trace.values, POINTS)
    )
    known = trace.values[np.isfinite(trace.values)]
    peak = float(known[np.argmax(np.abs(known))]) if known.size else math.nan
    shown = f"{peak:.{_decimals(frame)}f}" if known.size else "–"
    return (
        f'<g class="{trace.color}" data-decimals="{_decimals(frame)}">{lines}'
        f'<text class="value" x="{RIGHT + 8:g}" y="{coordinate(baseline)}"><tspan>{shown}</tspan>'
        f" {text(row.unit)}</text></g>"
    )


def _xs(frame: Frame, time: Array) -> list[float]:
    result: list[float] = (LEFT + (RIGHT - LEFT) / frame.end * time).tolist()
    return result


def _ys(frame: Frame, values: Array) -> list[float]:
    scale = frame.height / (frame.high - frame.low)
    result: list[float] = (frame.top + scale * (frame.high - values)).tolist()
    return result


def _decimals(frame: Frame) -> int:
    """Return the decimals that show a thousandth of the axis."""
    return min(max(2 - math.floor(math.log10(frame.high - frame.low)), 0), 5)


def _short(name: str) -> str:
    return name if len(name) <= 13 else name[:12] + "…"
