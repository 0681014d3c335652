"""How long a run stood at the waits of its programs."""

import math
from collections.abc import Iterable

from ropsim.core import frozen_dataclass
from ropsim.flow.events import AwaitEvent, Event, WaitEvent

_SAME = 1e-9
"""A wait that begins so soon after another one on its line goes on with it [s]."""


@frozen_dataclass
class Waiting:
    """Time in which programs stood at a `wait`, for a time, a signal or a condition, or polled in a loop.

    Attributes:
        total: over all waits [s].
        share: of the cycle time; 0 for a run of no length.
        longest: of a single wait [s]; a condition that is polled counts as one.
        time: when that wait began [s]; NaN without waits.
        line: its source line, 0 where unknown.
        visit: its loop pass, 0 where unknown.
        station: name of the station whose program waited; empty where unknown.
    """

    total: float = 0.0
    share: float = 0.0
    longest: float = 0.0
    time: float = math.nan
    line: int = 0
    visit: int = 0
    station: str = ""


def waiting_of(events: Iterable[Event], cycle_time: float) -> Waiting:
    """Return how long programs stood at waits.

    Args:
        events: of a run, for each station in order of time.
        cycle_time: of the run [s]; of several stations together the sum of theirs.
    """
    waits = [event for event in events if isinstance(event, WaitEvent | AwaitEvent)]
    if not waits:
        return Waiting()
    total = sum(event.duration for event in waits)
    waits_on_lines: list[tuple[Event, float]] = []
    open_ones: dict[str, int] = {}
    for event in waits:
        at = open_ones.get(event.station)
        first, end = waits_on_lines[at] if at is not None else (event, -math.inf)
        if at is not None and first.line == event.line and event.time - end < _SAME:
            waits_on_lines[at] = (first, event.end)
        else:
            open_ones[event.station] = len(waits_on_lines)
            waits_on_lines.append((event, event.end))
    longest, end = max(waits_on_lines, key=lambda one: one[1] - one[0].time)
    return Waiting(
        total,
        total / cycle_time if cycle_time > 0.0 else 0.0,
        end - longest.time,
        longest.time,
        longest.line,
        longest.visit,
        longest.station,
    )
