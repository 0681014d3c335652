"""Which charts the report has, made from the channels of a recording."""

from collections.abc import Callable

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.flow import AxisFacts, AxisType, GripEvent, MotionKind, MoveEvent, Recording, ReleaseEvent
from ropsim.spatial import Array
from ropsim.views.channels import StationView, station_views
from ropsim.views.chart.chart import Interval, TimeChart, Trace, TraceRow, time_chart
from ropsim.views.chart.plane import PlaneChart, Spot, plane_chart
from ropsim.views.html.strips import figure, schedule, signals
from ropsim.views.summary.path_summary import speed
from ropsim.views.summary.summary import Summary
from ropsim.views.words.figures import (
    AMPERE,
    MILLIMETRES,
    MILLIMETRES_PER_SECOND,
    WATT,
    Scale,
    coordinate_scale,
    effort_scale,
    speed_scale,
)


@frozen_dataclass
class _JointQuantity:
    """A quantity that every joint has: which channel, in which unit, against which limits."""

    channel: str
    title: str
    description: str
    scale: Callable[[AxisType], Scale]
    limits: Callable[[AxisFacts], tuple[float, ...]]


_QUANTITIES = (
    _JointQuantity(
        "q",
        "Joint coordinates",
        "Attained coordinate of each joint.",
        coordinate_scale,
        lambda j: (j.lower, j.upper),
    ),
    _JointQuantity(
        "qd",
        "Joint speeds",
        "Attained speed of each joint.",
        speed_scale,
        lambda j: (-j.max_speed, j.max_speed),
    ),
    _JointQuantity(
        "tau",
        "Joint torques",
        "Torque of the drive at each joint.",
        effort_scale,
        lambda j: (-j.max_effort, j.max_effort),
    ),
    _JointQuantity(
        "current",
        "Motor currents",
        "Current of each motor.",
        lambda _: AMPERE,
        lambda j: (-j.max_current, j.max_current),
    ),
    _JointQuantity(
        "power",
        "Power drawn by the drives",
        "Power that each drive draws, negative where it gives back.",
        lambda _: WATT,
        lambda _: (),
    ),
    _JointQuantity(
        "q_error",
        "Following errors",
        "Reference minus attained coordinate of each joint.",
        coordinate_scale,
        lambda _: (),
    ),
)


def figures(recording: Recording, summary: Summary) -> list[str]:
    """Return the figures of the report in their order; a quantity without a finite sample has no figure."""
    stations = station_views(recording)
    candidates = [
        schedule(recording, summary),
        *(figure for station in stations for figure in (_path_views(station), _path_accuracy(station))),
        *(_joint_figure(stations, quantity) for quantity in _QUANTITIES),
        _power_figure(stations),
        signals(recording),
    ]
    return [figure for figure in candidates if figure]


def active_lines(recording: Recording) -> tuple[list[float], list[int]]:
    """Return when the active source line changes, and to which line; nothing of several programs."""
    stations = station_views(recording)
    channel = recording.channels.get(stations[0].name("line")) if len(stations) == 1 else None
    if channel is None or channel.times is None:
        return [], []
    return channel.times.tolist(), np.nan_to_num(channel.values).astype(int).tolist()


def _joint_figure(stations: tuple[StationView, ...], quantity: _JointQuantity) -> str:
    found = [(station, station.joints(quantity.channel)) for station in stations]
    rows = tuple(
        _joint_row(station.label(f"joint {axis.name}"), axis, quantity, values[:, k])
        for station, values in found
        if np.any(np.isfinite(values)) and (station.is_driven or quantity.channel != "q_error")
        for k, axis in enumerate(station.facts.axes)
    )
    if not rows:
        return ""
    has_limits = any(row.limits for row in rows)
    description = quantity.description + (
        " Limits are drawn where the joint comes near." if has_limits else ""
    )
    time = found[0][0].time
    chart = TimeChart(f"chart-{quantity.channel}", quantity.title, description, time, rows)
    return figure(quantity.title, ("limit", "peak") if has_limits else ("peak",), time_chart(chart))


def _power_figure(stations: tuple[StationView, ...]) -> str:
    """Return the power of all drives of each station together."""
    powers = [(station, station.joints("power")) for station in stations]
    rows = tuple(
        TraceRow(
            station.label("all drives"), WATT.unit, (Trace("power", np.nansum(values, axis=1)),), height=80.0
        )
        for station, values in powers
        if np.any(np.isfinite(values))
    )
    if not rows:
        return ""
    title = "Power drawn by all drives"
    what = "Power of all drives together, which share a supply; negative where they give back."
    return figure(
        title, ("peak",), time_chart(TimeChart("chart-supply", title, what, stations[0].time, rows))
    )


def _joint_row(name: str, axis: AxisFacts, quantity: _JointQuantity, values: Array) -> TraceRow:
    scale = quantity.scale(axis.type)
    limits = tuple(limit * scale.factor for limit in quantity.limits(axis))
    return TraceRow(name, scale.unit, (Trace("attained", values * scale.factor),), limits)


def _path_accuracy(station: StationView) -> str:
    command = speed(station, "command_position") * MILLIMETRES_PER_SECOND.factor
    attained = speed(station, "attained_position") * MILLIMETRES_PER_SECOND.factor
    error = station.series("path_error") * MILLIMETRES.factor
    rows = []
    if np.any(np.isfinite(attained)):
        traces = (Trace("command", command, "c2"), Trace("attained", attained))
        rows.append(TraceRow("TCP speed", MILLIMETRES_PER_SECOND.unit, traces, height=100.0))
    if station.is_driven and np.any(np.isfinite(error)):
        rows.append(TraceRow("path error", MILLIMETRES.unit, (Trace("path error", error),), height=100.0))
    if not rows:
        return ""
    chart = TimeChart(
        f"chart-tcp{_suffix(station)}",
        station.label("TCP speed and path error"),
        "Speed of the tool centre point, and its distance from the path of the tool where a move has one.",
        station.time,
        tuple(rows),
        _tool_paths(station),
    )
    band = ("band",) if chart.bands else ()
    return figure(
        station.label("TCP speed and path error"), ("attained", "command", *band, "peak"), time_chart(chart)
    )


def _suffix(station: StationView) -> str:
    """Return the suffix of names inside the page that distinguishes stations."""
    stations = station.recording.facts.stations
    return "" if len(stations) == 1 else f"-{stations.index(station.facts) + 1}"


def _tool_paths(station: StationView) -> list[Interval]:
    return [
        (event.time, event.end)
        for event in station.recording.events
        if isinstance(event, MoveEvent)
        and event.motion != MotionKind.PTP
        and event.station == station.facts.name
    ]


def _path_views(station: StationView) -> str:
    position = station.matrix("attained_position", 3) * MILLIMETRES.factor
    if not np.any(np.isfinite(position)):
        return ""
    straight = np.isfinite(station.series("path_error"))
    views = "".join(
        plane_chart(
            PlaneChart(
                f"chart-{ident}{_suffix(station)}",
                f"TCP path, {name}",
                f"Attained path of the tool centre point in the base frame, {name}, equal scales.",
                (f"{axes[0]} [mm]", f"{axes[1]} [mm]"),
                position[:, "xyz".index(axes[0])],
                position[:, "xyz".index(axes[1])],
                straight,
                _spots(station, position, axes),
            )
        )
        for ident, name, axes in (("top", "top view", "xy"), ("side", "side view", "xz"))
    )
    line = ("straight",) if np.any(straight) else ()
    keys = ("way", *line, "grip", "release")
    return figure(
        station.label("TCP path in the base frame: top view and side view"),
        keys,
        f'<div class="pair">{views}</div>',
    )


def _spots(station: StationView, position: Array, axes: str) -> tuple[Spot, ...]:
    spots: dict[Spot, None] = {}
    for event in station.recording.events:
        own = isinstance(event, GripEvent | ReleaseEvent) and event.station == station.facts.name
        if own and station.time.size:
            index = min(int(np.searchsorted(station.time, event.time)), station.time.size - 1)
            x, y = (float(position[index, "xyz".index(axis)]) for axis in axes)
            if np.isfinite(x) and np.isfinite(y):
                spots[Spot(event.kind, round(x), round(y))] = None
    return tuple(spots)
