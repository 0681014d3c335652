"""Summary of each device of a run, and times of tasks."""

import math

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.flow import AxisType, ChannelGroup, Recording, TaskEvent
from ropsim.views.channels import labelled
from ropsim.views.words.characters import clean
from ropsim.views.words.figures import coordinate_scale, fixed, with_unit


@frozen_dataclass
class DeviceSummary:
    """One device in one run; lengths and angles in the unit of its coordinate.

    Attributes:
        name: of the device.
        type: whether its axis turns or slides.
        travel: sum of all its ways, back and forth [rad | m].
        lowest: least coordinate [rad | m].
        highest: greatest coordinate [rad | m].
    """

    name: str
    type: AxisType
    travel: float
    lowest: float
    highest: float


def summarize_devices(recording: Recording) -> tuple[DeviceSummary, ...]:
    """Return the figures of every device that the recording has a coordinate of, in its order."""
    found = []
    for channel in recording.channels.values():
        if channel.group is not ChannelGroup.DEVICES:
            continue
        q = channel.rows(recording.time).reshape(len(recording.time), -1)[:, :1].ravel()
        q = q[np.isfinite(q)]
        kind = AxisType.REVOLUTE if channel.unit == "rad" else AxisType.PRISMATIC
        ends = (float(q.min()), float(q.max())) if q.size else (math.nan, math.nan)
        travel = float(np.sum(np.abs(np.diff(q)))) if q.size else math.nan
        found.append(DeviceSummary(channel.subject, kind, travel, *ends))
    return tuple(found)


def device_text(device: DeviceSummary) -> str:
    """Return the activity of a device, such as `door went 1700.0 mm, between 0.0 and 850.0 mm`.

    Of one that only went on from 0, as belts do, the way says all.
    """
    scale = coordinate_scale(device.type)
    if device.lowest == 0.0 and math.isclose(device.travel, device.highest, rel_tol=1e-9):
        return f"{clean(device.name)} went {with_unit(device.travel, scale, 1)}"
    way, low = with_unit(device.travel, scale, 1), fixed(device.lowest, scale, 1)
    return f"{clean(device.name)} went {way}, between {low} and {with_unit(device.highest, scale, 1)}"


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
