"""What a recording proves against the limits of the arm: torque, current, speed, range, voltage."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ropsim.core import Diagnostic, Kind, Span
from ropsim.flow import Channel
from ropsim.model import SPEED_OVERSHOOT, Cell, JointType, RobotModel
from ropsim.simulation.diagnostics import (
    CURRENT_EXCEEDED,
    EFFORT_EXCEEDED,
    FOLLOWING_ERROR,
    LIMIT_OVERRUN,
    SPEED_EXCEEDED,
    VOLTAGE_SATURATED,
)
from ropsim.spatial import Array

#: Time at the voltage limit that is a finding [s].
SATURATION_TIME = 0.05
#: Following error at which a real controller would long have stopped [rad | m].
FOLLOWING = 0.1
#: Overrun of a joint limit that is a finding [rad | m]: well above rounding, below any end stop's play.
OVERRUN = 1e-4

_SHOWN = {
    "speed": {JointType.REVOLUTE: (180 / np.pi, "°/s"), JointType.PRISMATIC: (1e3, "mm/s")},
    "overrun": {JointType.REVOLUTE: (180 / np.pi, "°"), JointType.PRISMATIC: (1e3, "mm")},
    "following error": {JointType.REVOLUTE: (180 / np.pi, "°"), JointType.PRISMATIC: (1e3, "mm")},
    "torque": {JointType.REVOLUTE: (1.0, "N·m"), JointType.PRISMATIC: (1.0, "N")},
    "current": dict.fromkeys(JointType, (1.0, "A")),
    "time at full voltage": dict.fromkeys(JointType, (1.0, "s")),
}


@dataclass(frozen=True, slots=True)
class _Check:
    """One kind of limit; `values` (k, n) and `limits` (n,) in SI units."""

    kind: Kind
    quantity: str
    values: Array
    limits: Array


def verdicts(cell: Cell, time: Array, channels: Mapping[str, Channel], source: str) -> tuple[Diagnostic, ...]:
    """Return one finding per joint and kind of limit that was broken, at the line of the worst moment.

    Args:
        cell: with the limits.
        time: [s], shape (k,).
        channels: as recorded.
        source: name of the text that the channel `line` counts in.
    """
    lines = channels["line"].values
    found = []
    for check in _checks(cell.robot, time, channels):
        rows = np.argmax(np.abs(check.values), axis=0)
        for joint, row in enumerate(rows):
            value = float(abs(check.values[row, joint]))
            if value > check.limits[joint]:
                found.append(
                    _finding(cell.robot, check, joint, value, float(time[row]), int(lines[row]), source)
                )
    return tuple(found)


def _checks(robot: RobotModel, time: Array, channels: Mapping[str, Channel]) -> list[_Check]:
    q = channels["q"].values
    beyond = np.maximum(np.maximum(q - robot.upper_limits, robot.lower_limits - q), 0.0)
    checks = [
        _Check(SPEED_EXCEEDED, "speed", channels["qd"].values, robot.max_speeds * (1 + SPEED_OVERSHOOT)),
        _Check(LIMIT_OVERRUN, "overrun", beyond, np.full(robot.n, OVERRUN)),
        _Check(FOLLOWING_ERROR, "following error", channels["q_error"].values, np.full(robot.n, FOLLOWING)),
    ]
    if "tau" not in channels:
        return checks
    currents = np.array([drive.amplifier.max_current for drive in robot.drives])
    voltages = np.array([drive.amplifier.max_voltage for drive in robot.drives])
    period = float(time[1] - time[0]) if len(time) > 1 else 0.0
    full = np.abs(channels["voltage"].values) >= voltages * (1 - 1e-9)
    # the time at full voltage so far, kept only where it grows: its maximum is at the last such row
    lasting = np.where(full, np.cumsum(full, axis=0) * period, 0.0)
    return [
        *checks,
        _Check(EFFORT_EXCEEDED, "torque", channels["tau"].values, robot.max_efforts),
        _Check(CURRENT_EXCEEDED, "current", channels["current"].values, currents),
        _Check(VOLTAGE_SATURATED, "time at full voltage", lasting, np.full(robot.n, SATURATION_TIME)),
    ]


def _finding(
    robot: RobotModel, check: _Check, joint: int, value: float, time: float, line: int, source: str
) -> Diagnostic:
    scale, unit = _SHOWN[check.quantity][robot.joints[joint].type]
    limit = float(check.limits[joint])
    return check.kind.at(
        Span.whole_line(source, line) if line else None,
        f"{check.quantity} of joint `{robot.joints[joint].name}` reached {value * scale:.4g} {unit}, "
        f"the limit is {limit * scale:.4g} {unit}",
        label=f"at t = {time:.2f} s",
        hint="lower the speed or acceleration here, or the payload",
        data={"joint": joint + 1, "value": value, "limit": limit, "time_s": time},
    )
