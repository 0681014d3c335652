"""Control ticks of a station by kind, event by event."""

import math
from collections.abc import Iterable, Iterator, Set

from ropsim.core import frozen_dataclass
from ropsim.flow import AwaitEvent, Event, GripEvent, MoveEvent, ReleaseEvent, TaskEvent, WaitEvent
from ropsim.views.cycle.parts import Kind, Ticks


@frozen_dataclass
class Spent:
    """Time of one event.

    Attributes:
        event: the event.
        ticks: control ticks by kind.
    """

    event: Event
    ticks: Ticks


def spent(events: Iterable[Event], hz: float, partners: Set[str]) -> Iterator[Spent]:
    """Yield the time of each event of a station; events without time of their own are left out.

    Ends of parts are rounded to ticks, not their lengths, so the parts of an event sum to it exactly.

    Args:
        events: of one station.
        hz: control ticks per second.
        partners: channels that programs of other stations set.
    """
    for event in events:
        if isinstance(event, TaskEvent):
            continue
        count = ticks_of(event.end, hz) - ticks_of(event.time, hz)
        if isinstance(event, MoveEvent):
            yield Spent(event, _of_move(event, count, hz))
        elif isinstance(event, GripEvent | ReleaseEvent):
            yield Spent(event, {Kind.GRIPPER: count})
        elif isinstance(event, AwaitEvent):
            yield Spent(event, {_waited({event.channel}, partners): count})
        elif isinstance(event, WaitEvent):
            yield Spent(event, {_waited(set(event.looked), partners): count})


def ticks_of(time: float, hz: float) -> int:
    """Return the control tick at a time [s], 0 where that is no number."""
    place = time * hz
    return round(place) if math.isfinite(place) else 0


def _of_move(event: MoveEvent, count: int, hz: float) -> Ticks:
    settling = min(ticks_of(event.settle, hz), count)
    blending = min(ticks_of(event.blending, hz), count - settling)
    return {Kind.MOTION: count - settling - blending, Kind.BLENDING: blending, Kind.SETTLING: settling}


def _waited(channels: Set[str], partners: Set[str]) -> Kind:
    if not channels:
        return Kind.TIMERS
    return Kind.PARTNERS if channels & partners else Kind.SIGNALS
