"""A station of a run that has ended: what the checks of a run read."""

from bisect import bisect_left
from collections.abc import Sequence

import numpy as np

from ropsim.core import Span, frozen_dataclass
from ropsim.flow import Event
from ropsim.model import Cell, RobotModel
from ropsim.simulation.findings.circumstances import Circumstances, contact_words
from ropsim.simulation.records.tally import Tally
from ropsim.simulation.records.track import Track
from ropsim.spatial import Array


@frozen_dataclass
class PressedOn:
    """How hard meant contacts pressed on a station.

    Attributes:
        cell: with its contacts.
        ticks: of recorded rows, shape (m,).
        forces: size of the contact force at them [N], shape (m,).
    """

    cell: Cell
    ticks: Array
    forces: Array


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
        loop: advice where the joint controller is not the standard one, empty where it is.
        pressed: meant contacts; None without any.
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
    loop: str = ""
    pressed: PressedOn | None = None

    def span_of(self, line: int) -> Span | None:
        """Return the place of a line; None for line 0, which is none of the source."""
        return Span.whole_line(self.source, line) if line else None

    def span_at(self, tick: int) -> Span | None:
        """Return the place of the line in force at a control tick."""
        return self.span_of(int(self.lines.value(tick)))

    def circumstances(self, tick: int) -> Circumstances:
        """Return the causes besides the motion for a finding at a control tick, while its line is active."""
        if self.pressed is None:
            return Circumstances(self.loop)
        ticks = self.lines.ticks
        at = max(bisect_left(ticks, tick) - 1, 0)
        begin, end = (ticks[at], [*ticks[at + 1 :], np.inf][0]) if ticks else (0, np.inf)
        here = self.pressed.forces[(self.pressed.ticks >= begin) & (self.pressed.ticks <= end)]
        return Circumstances(self.loop, contact_words(self.pressed.cell, float(here.max(initial=0.0))))
