"""Time that settling after moves costs a run."""

import math
from collections.abc import Iterable

from ropsim.core import frozen_dataclass
from ropsim.flow.events import Event, MoveEvent

SLOW = 0.02
"""A move that settles longer than this [s] settles slowly."""


@frozen_dataclass
class Settling:
    """Time that the arm needed after moves until every joint was in position.

    Attributes:
        total: over all moves [s].
        share: of the cycle time; 0 for a run of no length.
        slow: number of moves that settled longer than `SLOW`.
        longest: of a single move [s].
        time: when that settling began [s]; NaN without moves.
        line: source line of that move, 0 where unknown.
        visit: its loop pass, 0 where unknown.
        station: name of the station that made it; empty where unknown.
    """

    total: float = 0.0
    share: float = 0.0
    slow: int = 0
    longest: float = 0.0
    time: float = math.nan
    line: int = 0
    visit: int = 0
    station: str = ""


def settling_of(events: Iterable[Event], cycle_time: float) -> Settling:
    """Return the cost of settling.

    Args:
        events: of a run.
        cycle_time: of the run [s]; of several stations together the sum of theirs.
    """
    moves = [event for event in events if isinstance(event, MoveEvent) and math.isfinite(event.settle)]
    if not moves:
        return Settling()
    total = sum(move.settle for move in moves)
    longest = max(moves, key=lambda move: move.settle)
    return Settling(
        total,
        total / cycle_time if cycle_time > 0.0 else 0.0,
        sum(move.settle > SLOW for move in moves),
        longest.settle,
        longest.end - longest.settle,
        longest.line,
        longest.visit,
        longest.station,
    )
