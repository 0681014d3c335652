"""Figures of what is on or off: tasks, instructions, gripper, signals."""

import numpy as np

from ropsim.flow import Recording
from ropsim.spatial import Array
from ropsim.views.channels import series
from ropsim.views.chart.chart import SpanRow, Stretch, TimeChart, Trace, TraceRow, time_chart
from ropsim.views.html.figure import figure
from ropsim.views.summary import Summary
from ropsim.views.task_summary import task_name

SHOWN_TASKS = 12
SHOWN_SIGNALS = 24

_INSTRUCTIONS = {"grip": "closing", "release": "opening", "wait": "waiting"}


def schedule(recording: Recording, summary: Summary) -> str:
    """Return when each task and each kind of instruction was active; empty where nothing was."""
    tasks: dict[str, list[Stretch]] = {}
    lanes: dict[str, list[Stretch]] = {}
    for event in recording.events:
        stretch = (event.time, event.time + event.duration)
        if event.kind == "task":
            tasks.setdefault(task_name(event), []).append(stretch)
        elif event.kind == "move":
            lanes.setdefault(str(event.data.get("kind", "move")), []).append(stretch)
        elif event.kind in _INSTRUCTIONS and event.duration > 0.0:
            lanes.setdefault(event.kind, []).append(stretch)
    names = [task.name for task in summary.tasks if task.name in tasks][:SHOWN_TASKS]
    kinds = sorted(lanes, key=lambda kind: (kind in _INSTRUCTIONS, kind))
    rows = [
        *(SpanRow(name, tasks[name]) for name in names),
        *(SpanRow(_INSTRUCTIONS.get(kind, kind), lanes[kind]) for kind in kinds),
    ]
    if not rows:
        return ""
    chart = TimeChart(
        "chart-schedule",
        "Tasks and instructions over time",
        "Bars show when each task and each kind of instruction was active.",
        recording.time,
        tuple(rows),
    )
    return figure("Tasks and instructions", (), time_chart(chart))


def signals(recording: Recording) -> str:
    """Return gripper, payload and signals over time; empty where none was recorded."""
    rows: list[TraceRow | SpanRow] = []
    gripper = series(recording, "gripper")
    if np.any(np.isfinite(gripper)):
        rows.append(SpanRow("gripper", _active(recording.time, gripper)))
    payload = series(recording, "payload")
    if np.any(np.isfinite(payload)):
        rows.append(TraceRow("payload", "kg", (Trace("payload", payload),), height=40.0))
    names = [name for name in recording.channels if name.startswith("signal.")]
    rows += [_signal(recording, name) for name in names[:SHOWN_SIGNALS]]
    if not rows:
        return ""
    chart = TimeChart(
        "chart-signals",
        "Gripper, payload and signals",
        "Bars show when the gripper is closed and when a binary signal is on.",
        recording.time,
        tuple(rows),
    )
    return figure("Gripper, payload and signals", (), time_chart(chart))


def _signal(recording: Recording, name: str) -> TraceRow | SpanRow:
    values = series(recording, name)
    label = name.removeprefix("signal.")
    if np.all(np.isin(values[np.isfinite(values)], (0.0, 1.0))):
        return SpanRow(label, _active(recording.time, values))
    return TraceRow(label, recording.channels[name].unit, (Trace(label, values),), height=40.0)


def _active(time: Array, values: Array) -> list[Stretch]:
    """Return the stretches of time in which a binary channel is on."""
    on = np.concatenate([[0], (np.nan_to_num(values) > 0.5).astype(int), [0]])
    starts, ends = np.flatnonzero(np.diff(on) == 1), np.flatnonzero(np.diff(on) == -1)
    last = max(time.size - 1, 0)
    return [
        (float(time[start]), float(time[min(end, last)]))
        for start, end in zip(starts.tolist(), ends.tolist(), strict=True)
    ]
