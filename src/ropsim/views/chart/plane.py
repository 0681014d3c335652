"""The path of the TCP in a plane as SVG, with equal scales on both axes."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ropsim.core import frozen_dataclass
from ropsim.spatial import Array, record
from ropsim.views.markup.decimate import along_curve
from ropsim.views.markup.markup import coordinate, points, text
from ropsim.views.markup.ticks import nice_ticks, padded, tick_text

WIDTH = 500.0
HEIGHT = 440.0
LEFT = 62.0
RIGHT = 486.0
TOP = 14.0
BOTTOM = 396.0
POINTS = 2500
TOLERANCE = 0.25
"""By how much of a pixel the drawn curve may be off, as long as it needs no more points than that."""


@frozen_dataclass
class Spot:
    """A place to mark: a circle (`grip`) or a square (`release`)."""

    kind: str
    x: float
    y: float


@record
class PlaneChart:
    """A path seen along one axis.

    Attributes:
        ident: unique name inside the page.
        title: such as `top view`.
        description: content of the picture, in a sentence.
        axes: names of the horizontal and the vertical axis, with units.
        x: shape (n,).
        y: shape (n,).
        straight: samples on straight moves, shape (n,).
        spots: places to mark.
    """

    ident: str
    title: str
    description: str
    axes: tuple[str, str]
    x: Array
    y: Array
    straight: npt.NDArray[np.bool_]
    spots: tuple[Spot, ...]


@record
class ContourChart:
    """A contour in its plane, and the attained path.

    Attributes:
        ident: unique name inside the page.
        title: such as `lines 4-7`.
        description: content of the picture, in a sentence.
        axes: names of the horizontal and the vertical axis, with units.
        wanted: the contour, shape (c, 2).
        attained: the attained path, with its distance from the contour enlarged, shape (k, 2).
    """

    ident: str
    title: str
    description: str
    axes: tuple[str, str]
    wanted: Array
    attained: Array


@frozen_dataclass
class _Frame:
    x0: float
    y0: float
    scale: float

    def x(self, value: float) -> float:
        return (LEFT + RIGHT) / 2 + (value - self.x0) * self.scale

    def y(self, value: float) -> float:
        return (TOP + BOTTOM) / 2 - (value - self.y0) * self.scale


def plane_chart(chart: PlaneChart) -> str:
    """Return the chart as an SVG element; straight moves and others have different lines."""
    known = np.isfinite(chart.x) & np.isfinite(chart.y)
    x, y, straight = chart.x[known], chart.y[known], chart.straight[known]
    frame = _fit(x, y)
    changes = np.flatnonzero(np.diff(straight)) + 1  # both sides: a straight move is drawn from end to end
    kept = along_curve(x, y, TOLERANCE / frame.scale, POINTS, np.concatenate((changes - 1, changes)))
    parts = [_grid(frame), _curve(frame, x[kept], y[kept], "c1"), _straight(frame, x, y, straight, kept)]
    parts += [_spot(frame, spot) for spot in chart.spots]
    return _svg((chart.ident, chart.title, chart.description), chart.axes, parts)


def contour_chart(chart: ContourChart) -> str:
    """Return the chart as an SVG element: the contour, and over it what was attained."""
    x, y = (np.concatenate((chart.wanted[:, k], chart.attained[:, k])) for k in (0, 1))
    frame, parts = _fit(x, y), []
    for way, color in ((chart.wanted, "c2"), (chart.attained, "c1")):
        kept = along_curve(way[:, 0], way[:, 1], TOLERANCE / frame.scale, POINTS, np.arange(0))
        parts.append(_curve(frame, way[kept, 0], way[kept, 1], color))
    return _svg((chart.ident, chart.title, chart.description), chart.axes, [_grid(frame), *parts])


def _svg(words: tuple[str, str, str], axes: tuple[str, str], parts: Sequence[str]) -> str:
    """Return parts as an element with identity, title and description, and names of its axes."""
    ident, title, description = words
    return (
        f'<svg class="plane" viewBox="0 0 {WIDTH:g} {HEIGHT:g}" role="img"'
        f' aria-labelledby="{ident}-t {ident}-d">\n'
        f'<title id="{ident}-t">{text(title)}</title>\n'
        f'<desc id="{ident}-d">{text(description)}</desc>\n{"".join(parts)}'
        f'<text class="middle tick" x="{(LEFT + RIGHT) / 2:g}" y="{HEIGHT - 6:g}">'
        f"{text(axes[0])}</text>"
        f'<text class="middle tick" transform="translate(14 {(TOP + BOTTOM) / 2:g}) rotate(-90)">'
        f"{text(axes[1])}</text></svg>\n"
    )


def _fit(x: Array, y: Array) -> _Frame:
    if x.size == 0:
        return _Frame(0.0, 0.0, 0.1)
    x_low, x_high = padded(float(x.min()), float(x.max()))
    y_low, y_high = padded(float(y.min()), float(y.max()))
    scale = min((RIGHT - LEFT) / (x_high - x_low), (BOTTOM - TOP) / (y_high - y_low))
    return _Frame((x_low + x_high) / 2, (y_low + y_high) / 2, scale)


def _grid(frame: _Frame) -> str:
    half_x, half_y = (RIGHT - LEFT) / 2 / frame.scale, (BOTTOM - TOP) / 2 / frame.scale
    xs = nice_ticks(frame.x0 - half_x, frame.x0 + half_x, 5)
    ys = nice_ticks(frame.y0 - half_y, frame.y0 + half_y, 5)
    parts = [
        f'<rect class="plot" x="{LEFT:g}" y="{TOP:g}" width="{RIGHT - LEFT:g}" height="{BOTTOM - TOP:g}"/>'
    ]
    for tick in xs:
        x = coordinate(frame.x(tick))
        parts.append(f'<line class="grid" x1="{x}" x2="{x}" y1="{TOP:g}" y2="{BOTTOM:g}"/>')
        parts.append(f'<text class="middle tick" x="{x}" y="{BOTTOM + 16:g}">{tick_text(tick, xs)}</text>')
    for tick in ys:
        y = frame.y(tick)
        parts.append(
            f'<line class="grid" x1="{LEFT:g}" x2="{RIGHT:g}" y1="{coordinate(y)}" y2="{coordinate(y)}"/>'
        )
        parts.append(
            f'<text class="end tick" x="{LEFT - 6:g}" y="{coordinate(y + 3.5)}">{tick_text(tick, ys)}</text>'
        )
    return "".join(parts)


def _curve(frame: _Frame, x: Array, y: Array, color: str) -> str:
    if x.size == 0:
        return ""
    place = points((frame.x(value) for value in x.tolist()), (frame.y(value) for value in y.tolist()))
    return f'<g class="{color}"><polyline points="{place}"/></g>\n'


def _straight(
    frame: _Frame, x: Array, y: Array, straight: npt.NDArray[np.bool_], kept: npt.NDArray[np.intp]
) -> str:
    """Draw the straight moves over the path: a line from the first to the last kept sample of each run."""
    inside = kept[straight[kept]]
    bends = np.cumsum(~straight)[inside]
    runs = np.split(inside, np.flatnonzero(np.diff(bends)) + 1)
    return "".join(_curve(frame, x[run], y[run], "c2") for run in runs if run.size > 1)


def _spot(frame: _Frame, spot: Spot) -> str:
    x, y = frame.x(spot.x), frame.y(spot.y)
    if spot.kind == "grip":
        return f'<circle class="spot" cx="{coordinate(x)}" cy="{coordinate(y)}" r="4"/>'
    return f'<rect class="spot" x="{coordinate(x - 3)}" y="{coordinate(y - 3)}" width="6" height="6"/>'
