"""How long each task took."""

from ropsim.core import frozen_dataclass
from ropsim.flow import Recording, TaskEvent
from ropsim.views.channels import labelled


@frozen_dataclass
class TaskSummary:
    """All activations of one task.

    Attributes:
        name: of the task, with several stations that of its station before it.
        depth: smallest depth in the calls (0 = the main program).
        calls: number of activations.
        total: time spent in it, called tasks included [s].
        longest: longest activation [s].
    """

    name: str
    depth: int
    calls: int
    total: float
    longest: float

    @property
    def mean(self) -> float:
        """Return the mean time of an activation [s]."""
        return self.total / self.calls


def summarize_tasks(recording: Recording) -> tuple[TaskSummary, ...]:
    """Return the times of all tasks, callers before the called, the longest first within a depth."""
    by_name: dict[str, list[TaskEvent]] = {}
    for event in recording.events:
        if isinstance(event, TaskEvent):
            by_name.setdefault(labelled(recording, event.station, event.name), []).append(event)
    tasks = [
        TaskSummary(
            name,
            depth=min(event.depth for event in events),
            calls=len(events),
            total=sum(event.duration for event in events),
            longest=max(event.duration for event in events),
        )
        for name, events in by_name.items()
    ]
    return tuple(sorted(tasks, key=lambda task: (task.depth, -task.total, task.name)))
