"""Time of each source line and each task of a program by part, and the limit that sets it."""

from collections import Counter
from collections.abc import Iterable

from ropsim.core import frozen_dataclass
from ropsim.flow import CriticalLimit, LimitQuantity, MoveEvent
from ropsim.views.cycle.parts import CycleParts, Kind
from ropsim.views.cycle.spent import Spent


@frozen_dataclass
class CriticalShare:
    """The limit that sets the time of the moves of a line.

    Attributes:
        joint: name of the axis; empty for a limit of the tool on its path.
        quantity: limited quantity.
        share: of the travel of all moves of the line during which this limit is reached, in (0, 1].
    """

    joint: str
    quantity: LimitQuantity
    share: float


@frozen_dataclass
class LineCycle:
    """The time of all passes of a source line.

    Attributes:
        line: its number, 0 for events without a statement.
        passes: how many instructions took time there.
        parts: composition of its time.
        zone: largest one that was flown at its targets [m]; 0 where all moves stop.
        critical: limit that sets the time of its moves; None where they reach none.
    """

    line: int
    passes: int
    parts: CycleParts
    zone: float
    critical: CriticalShare | None


def lines_of(all_spent: Iterable[Spent], hz: float) -> tuple[LineCycle, ...]:
    """Return the time of each line by part, the longest first.

    Args:
        all_spent: by the events of a station.
        hz: control ticks per second.
    """
    by_line: dict[int, list[Spent]] = {}
    for one in all_spent:
        by_line.setdefault(one.event.line, []).append(one)
    found = [_line(line, entries, hz) for line, entries in by_line.items()]
    return tuple(sorted(found, key=lambda line: (-line.parts.total, line.line)))


def _line(line: int, entries: list[Spent], hz: float) -> LineCycle:
    ticks: Counter[Kind] = Counter()
    for one in entries:
        ticks.update(one.ticks)
    moves = [one.event for one in entries if isinstance(one.event, MoveEvent)]
    zone = max((move.flown for move in moves), default=0.0)
    return LineCycle(line, len(entries), CycleParts.of(ticks, hz), zone, _critical(moves))


def _critical(moves: list[MoveEvent]) -> CriticalShare | None:
    """Return the limit that moves are at for longest, each counted by its time."""
    times: dict[tuple[str, LimitQuantity], float] = {}
    for move in moves:
        limit: CriticalLimit | None = move.critical
        if limit is not None:
            known = times.get((limit.joint, limit.quantity), 0.0)
            times[limit.joint, limit.quantity] = known + limit.share * move.travel
    travel = sum(move.travel for move in moves)
    if not times or not travel > 0.0:
        return None
    joint, quantity = longest = max(times, key=times.__getitem__)
    return CriticalShare(joint, quantity, min(times[longest] / travel, 1.0))


@frozen_dataclass
class TaskCycle:
    """The time of all activations of a task, without the time of called tasks.

    Attributes:
        name: of the task; `main` for statements outside tasks, empty for events without a statement.
        parts: composition of its time.
    """

    name: str
    parts: CycleParts


def tasks_of(all_spent: Iterable[Spent], hz: float) -> tuple[TaskCycle, ...]:
    """Return the time of each task by part, the longest first.

    Args:
        all_spent: by the events of a station.
        hz: control ticks per second.
    """
    tasks: dict[str, Counter[Kind]] = {}
    for one in all_spent:
        origin = one.event.origin
        name = origin.calls[-1] if origin and origin.calls else ""
        tasks.setdefault(name, Counter()).update(one.ticks)
    found = [TaskCycle(name, CycleParts.of(ticks, hz)) for name, ticks in tasks.items()]
    return tuple(sorted(found, key=lambda task: (-task.parts.total, task.name)))
