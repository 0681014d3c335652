"""Which charts the report has, made from the channels of a recording."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ropsim.flow import Recording
from ropsim.model import JointType
from ropsim.spatial import Array
from ropsim.views.channels import matrix, series
from ropsim.views.chart.chart import Stretch, TimeChart, Trace, TraceRow, time_chart
from ropsim.views.chart.plane import PlaneChart, Spot, plane_chart
from ropsim.views.figures import (
    AMPERE,
    MILLIMETRES,
    MILLIMETRES_PER_SECOND,
    Scale,
    coordinate_scale,
    effort_scale,
    speed_scale,
)
from ropsim.views.header import JointFacts
from ropsim.views.html.figure import figure
from ropsim.views.html.strips import schedule, signals
from ropsim.views.path_summary import speed
from ropsim.views.summary import Summary


@dataclass(frozen=True, slots=True)
class _JointQuantity:
    """A quantity that every joint has: which channel, in which unit, against which limits."""

    channel: str
    title: str
    description: str
    scale: Callable[[JointType], Scale]
    limits: Callable[[JointFacts], tuple[float, ...]]


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
        "q_error",
        "Following errors",
        "Reference minus attained coordinate of each joint.",
        coordinate_scale,
        lambda _: (),
    ),
)


def figures(recording: Recording, summary: Summary) -> list[str]:
    """Return the figures of the report in their order; a quantity without a finite sample has none."""
    candidates = [
        schedule(recording, summary),
        _path_views(recording),
        _path_accuracy(recording),
        *(_joint_figure(recording, summary.header.joints, quantity) for quantity in _QUANTITIES),
        signals(recording),
    ]
    return [figure for figure in candidates if figure]


def active_lines(recording: Recording) -> tuple[list[float], list[int]]:
    """Return at which times the active source line changes, and to which line."""
    lines = np.nan_to_num(series(recording, "line"))
    if lines.size == 0:
        return [], []
    changes = np.concatenate([[0], np.flatnonzero(np.diff(lines)) + 1])
    return recording.time[changes].tolist(), lines[changes].astype(int).tolist()


def _joint_figure(recording: Recording, joints: tuple[JointFacts, ...], quantity: _JointQuantity) -> str:
    values = matrix(recording, quantity.channel, len(joints))
    if not np.any(np.isfinite(values)):
        return ""
    rows = tuple(
        TraceRow(
            f"joint {joint.name}",
            scale.unit,
            (Trace("attained", values[:, k] * scale.factor),),
            tuple(limit * scale.factor for limit in quantity.limits(joint)),
        )
        for k, (joint, scale) in enumerate((joint, quantity.scale(joint.type)) for joint in joints)
    )
    has_limits = any(row.limits for row in rows)
    description = quantity.description + (
        " Limits are drawn where the joint comes near." if has_limits else ""
    )
    chart = TimeChart(f"chart-{quantity.channel}", quantity.title, description, recording.time, rows)
    return figure(quantity.title, ("limit", "peak") if has_limits else ("peak",), time_chart(chart))


def _path_accuracy(recording: Recording) -> str:
    command = speed(recording, "command_position") * MILLIMETRES_PER_SECOND.factor
    attained = speed(recording, "attained_position") * MILLIMETRES_PER_SECOND.factor
    error = series(recording, "path_error") * MILLIMETRES.factor
    rows = []
    if np.any(np.isfinite(attained)):
        traces = (Trace("command", command, "c2"), Trace("attained", attained))
        rows.append(TraceRow("TCP speed", MILLIMETRES_PER_SECOND.unit, traces, height=100.0))
    if np.any(np.isfinite(error)):
        rows.append(TraceRow("path error", MILLIMETRES.unit, (Trace("path error", error),), height=100.0))
    if not rows:
        return ""
    chart = TimeChart(
        "chart-tcp",
        "TCP speed and path error",
        "Speed of the tool centre point, and its distance from the commanded line on LIN moves.",
        recording.time,
        tuple(rows),
        _straight_moves(recording),
    )
    band = ("band",) if chart.bands else ()
    return figure("TCP speed and path error", ("attained", "command", *band, "peak"), time_chart(chart))


def _straight_moves(recording: Recording) -> list[Stretch]:
    return [
        (event.time, event.time + event.duration)
        for event in recording.events
        if event.kind == "move" and event.data.get("kind") == "LIN"
    ]


def _path_views(recording: Recording) -> str:
    position = matrix(recording, "attained_position", 3)
    if not np.any(np.isfinite(position)):
        return ""
    straight = np.isfinite(series(recording, "path_error"))
    views = "".join(
        plane_chart(
            PlaneChart(
                f"chart-{ident}",
                f"TCP path, {name}",
                f"Attained path of the tool centre point in the base frame, {name}, equal scales.",
                (f"{axes[0]} [m]", f"{axes[1]} [m]"),
                position[:, "xyz".index(axes[0])],
                position[:, "xyz".index(axes[1])],
                straight,
                _spots(recording, position, axes),
            )
        )
        for ident, name, axes in (("top", "top view", "xy"), ("side", "side view", "xz"))
    )
    line = ("straight",) if np.any(straight) else ()
    keys = ("way", *line, "grip", "release")
    return figure(
        "TCP path in the base frame: top view and side view", keys, f'<div class="pair">{views}</div>'
    )


def _spots(recording: Recording, position: Array, axes: str) -> tuple[Spot, ...]:
    spots: dict[Spot, None] = {}
    for event in recording.events:
        if event.kind in {"grip", "release"} and recording.time.size:
            index = min(int(np.searchsorted(recording.time, event.time)), recording.time.size - 1)
            x, y = (float(position[index, "xyz".index(axis)]) for axis in axes)
            if np.isfinite(x) and np.isfinite(y):
                spots[Spot(event.kind, round(x, 3), round(y, 3))] = None
    return tuple(spots)
