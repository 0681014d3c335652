"""What a recording proves against the limits of the arm: torque, current, speed, range, voltage."""

from collections.abc import Mapping

import numpy as np

from ropsim.core import Diagnostic, Kind, Span
from ropsim.flow import Channel
from ropsim.model import Cell
from ropsim.simulation.diagnostics import (
    CURRENT_EXCEEDED,
    EFFORT_EXCEEDED,
    LIMIT_OVERRUN,
    SPEED_EXCEEDED,
    VOLTAGE_SATURATED,
)
from ropsim.spatial import Array

#: Share by which an attained speed may exceed the limit before it is a finding (servo overshoot).
SPEED_OVERSHOOT = 0.02
#: Time at the voltage limit that is a finding [s].
SATURATION_TIME = 0.05
#: Overrun of a joint limit that is a finding [rad | m]: well above rounding, below any end stop's play.
OVERRUN = 1e-4


def verdicts(cell: Cell, time: Array, channels: Mapping[str, Channel], source: str) -> tuple[Diagnostic, ...]:
    """Return one finding per joint and kind of limit that was broken, at the line of the worst moment.

    Args:
        cell: with the limits.
        time: [s], shape (k,).
        channels: as recorded.
        source: name of the text that the channel `line` counts in.
    """
    robot = cell.robot
    line = channels["line"].values if "line" in channels else np.zeros(len(time))
    found: list[Diagnostic] = []

    def judge(kind: Kind, what: str, values: Array, limits: Array, unit: str, scale: float) -> None:
        for joint in range(robot.n):
            worst = int(np.argmax(np.abs(values[:, joint])))
            value = float(abs(values[worst, joint]))
            if value > limits[joint]:
                found.append(
                    _finding(kind, what, joint, value * scale, float(limits[joint]) * scale, unit, worst)
                )

    def _finding(
        kind: Kind, what: str, joint: int, value: float, limit: float, unit: str, row: int
    ) -> Diagnostic:
        number = int(line[row])
        return kind.at(
            Span.on_line(source, number, 1) if number else None,
            f"{what} of joint `{robot.joints[joint].name}` reached {value:.4g} {unit}, the limit is {limit:.4g} {unit}",
            label=f"at t = {time[row]:.2f} s",
            hint="lower the speed or acceleration here, or the payload",
            data={"joint": joint + 1, "value": value, "limit": limit, "time_s": float(time[row])},
        )

    judge(
        SPEED_EXCEEDED,
        "speed",
        channels["qd"].values,
        robot.max_speeds * (1 + SPEED_OVERSHOOT),
        "°/s",
        np.degrees(1),
    )
    beyond = np.maximum(channels["q"].values - robot.upper_limits, robot.lower_limits - channels["q"].values)
    judge(LIMIT_OVERRUN, "overrun", np.maximum(beyond, 0.0), np.full(robot.n, OVERRUN), "°", np.degrees(1))
    if "tau" in channels:
        judge(EFFORT_EXCEEDED, "torque", channels["tau"].values, robot.max_efforts, "N·m", 1.0)
        currents = np.array([drive.amplifier.max_current for drive in robot.drives])
        judge(CURRENT_EXCEEDED, "current", channels["current"].values, currents, "A", 1.0)
        voltages = np.array([drive.amplifier.max_voltage for drive in robot.drives])
        period = float(time[1] - time[0]) if len(time) > 1 else 0.0
        full = np.abs(channels["voltage"].values) >= voltages * (1 - 1e-9)
        for joint in np.flatnonzero(full.sum(axis=0) * period > SATURATION_TIME):
            seconds = float(full[:, joint].sum() * period)
            row = int(np.argmax(full[:, joint]))
            found.append(
                _finding(
                    VOLTAGE_SATURATED, "time at full voltage", int(joint), seconds, SATURATION_TIME, "s", row
                )
            )
    return tuple(found)
