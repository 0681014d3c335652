"""Frames and axes of charts over time: all charts of a page share the place of the time axis."""

from ropsim.core import frozen_dataclass
from ropsim.views.markup.markup import coordinate
from ropsim.views.markup.ticks import nice_ticks, tick_text

WIDTH = 1000.0
LEFT = 112.0
RIGHT = 908.0


@frozen_dataclass
class Frame:
    """Place of one row, and how time and values become coordinates."""

    end: float
    top: float
    height: float
    low: float = 0.0
    high: float = 1.0

    def x(self, time: float) -> float:
        """Return the coordinate of a time [s]."""
        return LEFT + (RIGHT - LEFT) * time / self.end

    def y(self, value: float) -> float:
        """Return the coordinate of a value."""
        return self.top + self.height * (self.high - value) / (self.high - self.low)


def _value_ticks(frame: Frame) -> tuple[float, ...]:
    """Return ticks that leave room for their numbers, two at least."""
    count = min(round(frame.height / 14), 5)
    ticks = nice_ticks(frame.low, frame.high, count)
    return ticks if len(ticks) > 1 else nice_ticks(frame.low, frame.high, 2 * count)


def value_axis(frame: Frame) -> str:
    """Return the plot area with grid lines and the numbers on the left."""
    ticks = _value_ticks(frame)
    parts = [
        f'<rect class="plot" x="{LEFT:g}" y="{coordinate(frame.top)}" width="{RIGHT - LEFT:g}"'
        f' height="{coordinate(frame.height)}"/>'
    ]
    for tick in ticks:
        y = frame.y(tick)
        kind = "zero" if abs(tick) < 1e-12 else "grid"
        parts.append(
            f'<line class="{kind}" x1="{LEFT:g}" x2="{RIGHT:g}" y1="{coordinate(y)}" y2="{coordinate(y)}"/>'
            f'<text class="end tick" x="{LEFT - 6:g}" y="{coordinate(y + 3.5)}">'
            f"{tick_text(tick, ticks)}</text>"
        )
    return "".join(parts)


def time_axis(end: float, bottom: float) -> str:
    """Return the time axis from 0 to `end` [s] below the coordinate `bottom`."""
    ticks = nice_ticks(0.0, end, 10)
    frame = Frame(end, 0.0, 1.0)
    marks = "".join(
        f'<line class="mark" x1="{coordinate(frame.x(tick))}" x2="{coordinate(frame.x(tick))}"'
        f' y1="{coordinate(bottom)}" y2="{coordinate(bottom + 4)}"/>'
        f'<text class="middle tick" x="{coordinate(frame.x(tick))}" y="{coordinate(bottom + 16)}">'
        f"{tick_text(tick, ticks)}</text>"
        for tick in ticks
    )
    return (
        f'<g><line class="mark" x1="{LEFT:g}" x2="{RIGHT:g}" y1="{coordinate(bottom)}"'
        f' y2="{coordinate(bottom)}"/>'
        f'{marks}<text class="tick" x="{RIGHT + 8:g}" y="{coordinate(bottom + 16)}">time [s]</text></g>\n'
    )
