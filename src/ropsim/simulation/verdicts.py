"""What a recording proves against the limits of the arm: torque, current, speed, range, voltage."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from ropsim.core import Diagnostic, Kind, Span
from ropsim.dynamics import Limit, LimitSort, chain_of
from ropsim.flow import Channel
from ropsim.model import OVERRUN, SPEED_OVERSHOOT, JointType, RobotModel
from ropsim.simulation.diagnostics import (
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

_DRIVE_LIMITS = {
    ("current", LimitSort.PEAK): CURRENT_EXCEEDED,
    ("current", LimitSort.LASTING): CURRENT_LIMITED,
    ("voltage", LimitSort.LASTING): VOLTAGE_SATURATED,
    ("command", LimitSort.LASTING): COMMAND_SATURATED,
}
"""How the limits of drives are told that have a page of their own."""
_ANY = {LimitSort.PEAK: DRIVE_EXCEEDED, LimitSort.LASTING: DRIVE_SATURATED}


@dataclass(frozen=True, slots=True)
class _Check:
    """One kind of limit; `values` (k, n) and `limits` (n,) in SI units, `shown` as factor and unit."""

    kind: Kind
    quantity: str
    shown: _Shown
    values: Array
    limits: Array


def verdicts(
    robot: RobotModel, time: Array, channels: Mapping[str, Channel], source: str
) -> tuple[Diagnostic, ...]:
    """Return one finding per joint and kind of limit that was broken, at the line of the worst moment.

    Args:
        robot: with the limits.
        time: [s], shape (k,).
        channels: as recorded.
        source: name of the text that the channel `line` counts in.
    """
    lines = channels["line"].rows(time)
    found = []
    for check in _checks(robot, time, channels):
        rows = np.argmax(np.abs(check.values), axis=0)
        for joint, row in enumerate(rows):
            value = float(abs(check.values[row, joint]))
            if value > check.limits[joint]:
                found.append(_finding(robot, check, joint, value, float(time[row]), int(lines[row]), source))
    return tuple(found)


def _checks(robot: RobotModel, time: Array, channels: Mapping[str, Channel]) -> list[_Check]:
    q = channels["q"].values
    beyond = np.maximum(np.maximum(q - robot.upper_limits, robot.lower_limits - q), 0.0)
    checks = [
        _Check(
            SPEED_EXCEEDED,
            "speed",
            _SPEED,
            channels["qd"].values,
            robot.max_speeds * (1 + SPEED_OVERSHOOT),
        ),
        _Check(LIMIT_OVERRUN, "overrun", _WAY, beyond, np.full(robot.n, OVERRUN)),
        _Check(
            FOLLOWING_ERROR,
            "following error",
            _WAY,
            channels["q_error"].values,
            np.full(robot.n, FOLLOWING),
        ),
    ]
    if "tau" not in channels:
        return checks
    checks.append(_Check(EFFORT_EXCEEDED, "torque", _EFFORT, channels["tau"].values, robot.max_efforts))
    return [*checks, *(_drive_check(robot, limit, time, channels) for limit in _drive_limits(robot))]


def _drive_limits(robot: RobotModel) -> dict[Limit, list[int]]:
    """Return the limits that drives have, each with the joints whose drives have it."""
    found: dict[Limit, list[int]] = {}
    for k, chain in enumerate(chain_of(drive) for drive in robot.drives):
        for limit in chain.amplifier.limits:
            found.setdefault(limit, []).append(k)
    return found


def _drive_check(robot: RobotModel, limit: Limit, time: Array, channels: Mapping[str, Channel]) -> _Check:
    """Return the check of a limit of drives; joints whose drives do not have it get no value and no limit."""
    kind = _DRIVE_LIMITS.get((limit.column, limit.sort), _ANY[limit.sort])
    quantity = limit.column
    shown: _Shown = dict.fromkeys(JointType, (1.0, channels[limit.column].unit))
    axes = _drive_limits(robot)[limit]
    values, limits = np.zeros((len(time), robot.n)), np.full(robot.n, np.inf)
    bounds = np.array([getattr(robot.drives[k].amplifier, limit.number) for k in axes])
    recorded = _of_axes(robot, channels[limit.column], axes)
    if limit.sort is LimitSort.PEAK:
        values[:, axes], limits[axes] = recorded, bounds
    else:
        period = float(time[1] - time[0]) if len(time) > 1 else 0.0
        full = np.abs(recorded) >= bounds * limit.near
        # the time at the limit so far, kept only where it grows: its maximum is at the last such row
        quantity, shown = f"time at full {limit.column}", _TIME
        values[:, axes], limits[axes] = np.where(full, np.cumsum(full, axis=0) * period, 0.0), SATURATION_TIME
    return _Check(kind, quantity, shown, values, limits)


def _of_axes(robot: RobotModel, channel: Channel, axes: Sequence[int]) -> Array:
    """Return the columns of some joints; others may have the quantity, too, but not the limit."""
    names = channel.columns or tuple(joint.name for joint in robot.axis_joints)
    return channel.values[:, [names.index(robot.axis_joints[k].name) for k in axes]]


def _finding(
    robot: RobotModel, check: _Check, joint: int, value: float, time: float, line: int, source: str
) -> Diagnostic:
    scale, unit = check.shown[robot.axis_joints[joint].measure]
    limit = float(check.limits[joint])
    return check.kind.at(
        Span.whole_line(source, line) if line else None,
        f"{check.quantity} of joint `{robot.axis_joints[joint].name}` reached {value * scale:.4g} {unit}, "
        f"the limit is {limit * scale:.4g} {unit}",
        label=f"at t = {time:.2f} s",
        hint="lower the speed or acceleration here, or the payload",
        data={"joint": joint + 1, "value": value, "limit": limit, "time_s": time},
    )
