"""The cycle time of a station in parts."""

import math
from collections import Counter
from dataclasses import field

from ropsim.core import frozen_dataclass
from ropsim.flow import Event, OutputEvent, Recording, StationFacts
from ropsim.views.cycle.line_cycle import LineCycle, TaskCycle, lines_of, tasks_of
from ropsim.views.cycle.parts import CycleParts, Kind
from ropsim.views.cycle.spent import Spent, spent, ticks_of

_FINE_HZ = 1e6
"""Ticks per second for distinguishing times if the control rate is unknown [Hz]."""


@frozen_dataclass
class CycleTime:
    """Composition of the cycle time of a station.

    The parts of the whole, of all tasks and of all lines each sum to the cycle time, to the tick.

    Attributes:
        whole: all of it.
        tasks: by task, the longest first.
        lines: by source line, the longest first.
    """

    whole: CycleParts = field(default_factory=CycleParts)
    tasks: tuple[TaskCycle, ...] = ()
    lines: tuple[LineCycle, ...] = ()


def summarize_cycle(recording: Recording, facts: StationFacts) -> CycleTime:
    """Return the composition of the cycle time of a station.

    Time between events, in which the program did nothing that is recorded, is `other` and of no line.

    Args:
        recording: of the whole run: outputs of other stations' programs identify waits for them.
        facts: of the station.
    """
    alone = len(recording.facts.stations) == 1
    own = [event for event in recording.events if alone or event.station == facts.name]
    others = [event for event in recording.events if not alone and event.station != facts.name]
    partners = {event.channel for event in others if isinstance(event, OutputEvent)}
    hz = facts.control_hz if math.isfinite(facts.control_hz) and facts.control_hz > 0.0 else _FINE_HZ
    found = list(spent(own, hz, partners))
    last = max((ticks_of(event.end, hz) for event in own), default=0)
    rest = last - sum(sum(one.ticks.values()) for one in found)
    if rest:
        found.append(Spent(Event(0.0), {Kind.OTHER: rest}))
    ticks: Counter[Kind] = Counter()
    for one in found:
        ticks.update(one.ticks)
    return CycleTime(CycleParts.of(ticks, hz), tasks_of(found, hz), lines_of(found, hz))
