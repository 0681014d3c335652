"""Figures of the HTML report, and of on/off states: tasks, instructions, gripper, signals."""

import numpy as np

from ropsim.flow import ChannelGroup, MoveEvent, Recording, TaskEvent
from ropsim.spatial import Array
from ropsim.views.channels import contact_forces, labelled, series, station_views
from ropsim.views.chart.chart import Interval, SpanRow, TimeChart, Trace, TraceRow, time_chart
from ropsim.views.markup.markup import text
from ropsim.views.summary.summary import Summary

_KEYS = {
    "limit": '<span class="key"><i class="limit"></i>limit</span>',
    "attained": '<span class="key"><i></i>attained</span>',
    "command": '<span class="key"><i class="c2"></i>command</span>',
    "band": '<span class="key"><i class="band"></i>tool path</span>',
    "contour": '<span class="key"><i class="c2"></i>contour</span>',
    "way": '<span class="key"><i></i>attained path</span>',
    "straight": '<span class="key"><i class="c2"></i>tool path</span>',
    "grip": '<span class="key"><i class="dot"></i>grip</span>',
    "release": '<span class="key"><i class="square"></i>release</span>',
    "peak": '<span class="key">right: largest value</span>',
}


def figure(title: str, keys: tuple[str, ...], body: str) -> str:
    """Return a picture with its title and the keys of its legend, in that order."""
    legend = "".join(_KEYS[key] for key in keys)
    caption = f"<figcaption><strong>{text(title)}</strong>{legend}</figcaption>"
    return f'<figure>{caption}\n<div class="scroll" tabindex="0">{body}</div></figure>\n'


SHOWN_TASKS = 12
SHOWN_SIGNALS = 24

_INSTRUCTIONS = {"grip": "closing", "release": "opening", "wait": "waiting", "await": "waiting"}


def schedule(recording: Recording, summary: Summary) -> str:
    """Return when each task and each kind of instruction was active; empty where nothing was."""
    tasks: dict[str, list[Interval]] = {}
    lanes: dict[tuple[str, str], list[Interval]] = {}
    for event in recording.events:
        if isinstance(event, TaskEvent):
            tasks.setdefault(labelled(recording, event.station, event.name), []).append(
                (event.time, event.end)
            )
        elif isinstance(event, MoveEvent):
            lanes.setdefault((event.station, event.motion), []).append((event.time, event.end))
        elif event.kind in _INSTRUCTIONS and event.duration > 0.0:
            doing = (event.station, _INSTRUCTIONS[event.kind])
            lanes.setdefault(doing, []).append((event.time, event.end))
    names = [task.name for task in summary.tasks if task.name in tasks][:SHOWN_TASKS]
    kinds = sorted(lanes, key=lambda lane: (lane[0], lane[1] in _INSTRUCTIONS.values(), lane[1]))
    rows = [
        *(SpanRow(name, tasks[name]) for name in names),
        *(SpanRow(labelled(recording, station, kind), lanes[station, kind]) for station, kind in kinds),
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
    for station in station_views(recording):
        if np.any(np.isfinite(station.series("gripper"))):
            rows.append(_row(recording, station.name("gripper"), station.label("gripper")))
        payload = station.series("payload")
        if np.any(np.isfinite(payload)):
            rows.append(TraceRow(station.label("payload"), "kg", (Trace("payload", payload),), height=40.0))
        force = contact_forces(station)
        if np.any(np.isfinite(force)):
            trace = Trace("contact force", force)
            rows.append(TraceRow(station.label("contact force"), "N", (trace,), height=40.0))
    names = [name for name, one in recording.channels.items() if one.group is ChannelGroup.SIGNALS]
    rows += [_row(recording, name, name.removeprefix("signal.")) for name in names[:SHOWN_SIGNALS]]
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


def _row(recording: Recording, name: str, label: str) -> TraceRow | SpanRow:
    """Return the row of a channel: bars where it is on or off, else its course."""
    channel = recording.channels[name]
    known = channel.values[np.isfinite(channel.values)]
    if channel.times is not None and np.all(np.isin(known, (0.0, 1.0))):
        return SpanRow(label, _active(channel.times, channel.values, recording.duration))
    return TraceRow(label, channel.unit, (Trace(label, series(recording, name)),), height=40.0)


def _active(times: Array, values: Array, end: float) -> list[Interval]:
    """Return the ranges of time in which a binary quantity is on."""
    ends = [*times[1:].tolist(), end]
    return [(float(time), stop) for time, stop, value in zip(times, ends, values, strict=True) if value > 0.5]
