"""Limit violations of a run: torque, current, speed, range, voltage."""

from collections.abc import Mapping
from typing import TypeAlias

import numpy as np

from ropsim.core import Diagnostic, Kind, frozen_dataclass
from ropsim.dynamics import Limit, LimitSort, chain_of
from ropsim.model import OVERRUN, SPEED_OVERSHOOT, JointType, RobotModel
from ropsim.simulation.diagnostics.limit_diagnostics import (
    COMMAND_SATURATED,
    CURRENT_EXCEEDED,
    CURRENT_LIMITED,
    DRIVE_EXCEEDED,
    DRIVE_SATURATED,
    EFFORT_EXCEEDED,
    FOLLOWING_ERROR,
    LIMIT_OVERRUN,
    SPEED_EXCEEDED,
    VOLTAGE_SATURATED,
)
from ropsim.simulation.findings.finished_station import FinishedStation
from ropsim.simulation.records.tally import Tally
from ropsim.simulation.servo.judged import drive_limits
from ropsim.simulation.servo.log import recorded
from ropsim.spatial import Array

#: Time at the limit of an amplifier that is a finding [s].
SATURATION_TIME = 0.05
#: Following error at which a real controller would long have stopped [rad | m].
FOLLOWING = 0.1

_Shown: TypeAlias = Mapping[JointType, tuple[float, str]]
_SPEED: _Shown = {JointType.REVOLUTE: (180 / np.pi, "°/s"), JointType.PRISMATIC: (1e3, "mm/s")}
_WAY: _Shown = {JointType.REVOLUTE: (180 / np.pi, "°"), JointType.PRISMATIC: (1e3, "mm")}
_EFFORT: _Shown = {JointType.REVOLUTE: (1.0, "N·m"), JointType.PRISMATIC: (1.0, "N")}
_TIME: _Shown = dict.fromkeys(JointType, (1.0, "s"))
_UNITS = {
    JointType.REVOLUTE: {"q": "rad", "tau": "N·m"},
    JointType.PRISMATIC: {"q": "m", "tau": "N"},
}
"""Placeholders for coordinate and effort in the units of columns."""

_DRIVE_LIMITS = {
    ("current", LimitSort.PEAK): CURRENT_EXCEEDED,
    ("current", LimitSort.LASTING): CURRENT_LIMITED,
    ("voltage", LimitSort.LASTING): VOLTAGE_SATURATED,
    ("command", LimitSort.LASTING): COMMAND_SATURATED,
}
"""Messages for limits of drives with their own diagnostic page."""
_ANY = {LimitSort.PEAK: DRIVE_EXCEEDED, LimitSort.LASTING: DRIVE_SATURATED}


@frozen_dataclass
class _Check:
    """One kind of limit.

    Attributes:
        kind: of the finding.
        quantity: its name for people.
        shown: factor and unit for people.
        axes: joints that have the limit.
        values: worst values [SI], shape (k,).
        ticks: control ticks of these, shape (k,).
        limits: [SI], shape (k,).
    """

    kind: Kind
    quantity: str
    shown: _Shown
    axes: tuple[int, ...]
    values: Array
    ticks: Array
    limits: Array


def verdicts(station: FinishedStation) -> tuple[Diagnostic, ...]:
    """Return one finding per joint and kind of limit that was broken, at the line of the worst moment.

    Every control tick counts, whether the recording has a row of it or not.
    """
    found = []
    for check in _checks(station.robot, station.tally, station.hz):
        for at in np.flatnonzero(check.values > check.limits):
            tick = int(check.ticks[at])
            found.append(_finding(station, check, int(at), tick))
    return tuple(found)


def _checks(robot: RobotModel, tally: Tally, hz: int) -> list[_Check]:
    peaks = (
        (SPEED_EXCEEDED, "speed", _SPEED, "qd", robot.max_speeds * (1 + SPEED_OVERSHOOT)),
        (LIMIT_OVERRUN, "overrun", _WAY, "overrun", np.full(robot.n, OVERRUN)),
        (FOLLOWING_ERROR, "following error", _WAY, "q_error", np.full(robot.n, FOLLOWING)),
        (EFFORT_EXCEEDED, "torque", _EFFORT, "tau", robot.max_efforts),
    )
    checks = [
        _Check(kind, quantity, shown, axes, *tally.worst(name), limits[list(axes)])
        for kind, quantity, shown, name, limits in peaks
        if (axes := tally.axes(name))
    ]
    if not tally.axes("tau"):
        return checks
    of_drives = drive_limits(robot).items()
    return [*checks, *(_drive_check(robot, limit, axes, tally, hz) for limit, axes in of_drives)]


def _drive_check(robot: RobotModel, limit: Limit, axes: list[int], tally: Tally, hz: int) -> _Check:
    """Return the check of a limit of the drives of some joints."""
    kind = _DRIVE_LIMITS.get((limit.column, limit.sort), _ANY[limit.sort])
    places = [tally.axes(limit.column).index(axis) for axis in axes]  # other axes may have the quantity also
    if limit.sort is LimitSort.PEAK:
        values, ticks = (one[places] for one in tally.worst(limit.column))
        bounds = np.array([getattr(robot.drives[axis].amplifier, limit.number) for axis in axes])
        return _Check(kind, limit.column, _shown(robot, limit, axes[0]), tuple(axes), values, ticks, bounds)
    counts, ticks = (one[places] for one in tally.at_limit(limit.column))
    most = np.full(len(axes), SATURATION_TIME)
    return _Check(
        kind, f"drive saturated, time at full {limit.column}", _TIME, tuple(axes), counts / hz, ticks, most
    )


def _shown(robot: RobotModel, limit: Limit, axis: int) -> _Shown:
    """Return the unit of a recorded quantity of drives."""
    columns = recorded(chain_of(robot.drives[axis]))
    (unit,) = {column.unit for column in columns if column.name == limit.column}
    return {kind: (1.0, unit.format(**units)) for kind, units in _UNITS.items()}


def _finding(station: FinishedStation, check: _Check, at: int, tick: int) -> Diagnostic:
    robot, time = station.robot, tick / station.hz
    joint, value, limit = check.axes[at], float(check.values[at]), float(check.limits[at])
    scale, unit = check.shown[robot.axis_joints[joint].measure]
    return check.kind.at(
        station.span_at(tick),
        f"{check.quantity} of joint `{robot.axis_joints[joint].name}` reached {value * scale:.4g} {unit}, "
        f"the limit is {limit * scale:.4g} {unit}",
        label=f"at t = {time:.2f} s",
        hint=station.circumstances(tick).hint("lower the speed or acceleration here, or the payload"),
        data={"joint": joint + 1, "value": value, "limit": limit, "time_s": time},
    )
