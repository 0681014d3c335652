"""What each task of a program spent its time on."""

from collections import Counter
from collections.abc import Iterable

from ropsim.core import frozen_dataclass
from ropsim.views.cycle.parts import CycleParts, Kind
from ropsim.views.cycle.spent import Spent


@frozen_dataclass
class TaskCycle:
    """The time of all activations of a task, without what the tasks that it called took.

    Attributes:
        name: of the task; `main` for what stands in none, empty for what no statement made.
        parts: of what its time consists.
    """

    name: str
    parts: CycleParts


def tasks_of(all_spent: Iterable[Spent], hz: float) -> tuple[TaskCycle, ...]:
    """Return what each task spent its time on, the longest first.

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
