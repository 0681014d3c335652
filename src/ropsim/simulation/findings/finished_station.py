"""A station of a run that has ended: what the checks of a run read."""

from collections.abc import Sequence

from ropsim.core import Span, frozen_dataclass
from ropsim.flow import Event
from ropsim.model import RobotModel
from ropsim.simulation.records.tally import Tally
from ropsim.simulation.records.track import Track


@frozen_dataclass
class FinishedStation:
    """A station of a run that has ended.

    Attributes:
        robot: with its limits, drives and rated payload.
        source: name of the text that its lines count in.
        hz: control ticks per second.
        duration: of the run [s].
        tally: largest magnitudes over all control ticks.
        lines: source lines in force.
        loads: mass of tool and parts in force [kg].
        events: of the station.
        slowed: lines that are reported because a joint slows them (M563).
    """

    robot: RobotModel
    source: str
    hz: int
    duration: float
    tally: Tally
    lines: Track
    loads: Track
    events: Sequence[Event]
    slowed: frozenset[int] = frozenset()

    def span_of(self, line: int) -> Span | None:
        """Return the place of a line; None for line 0, which is none of the source."""
        return Span.whole_line(self.source, line) if line else None

    def span_at(self, tick: int) -> Span | None:
        """Return the place of the line in force at a control tick."""
        return self.span_of(int(self.lines.value(tick)))
