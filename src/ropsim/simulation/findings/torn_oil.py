"""Violations of oil pressure in hydraulic drives: pressures that no oil can have, and drained supplies."""

import numpy as np

from ropsim.core import Diagnostic, plural
from ropsim.dynamics import SUPPLY, structure_of
from ropsim.model import Hydraulic
from ropsim.simulation.diagnostics.limit_diagnostics import OIL_TORN, SUPPLY_DRAINED
from ropsim.simulation.findings.finished_station import FinishedStation
from ropsim.simulation.servo.judged import BELOW, supply_floor
from ropsim.simulation.servo.log import floors

_BAR = 1e5


def drained_supplies(station: FinishedStation) -> tuple[Diagnostic, ...]:
    """Return S755 for each supply that has come below its precharge or its return, where that was worst."""
    robot, tally = station.robot, station.tally
    axes, found = tally.axes(BELOW + SUPPLY.name), []
    below, ticks = tally.worst(BELOW + SUPPLY.name) if axes else (np.zeros(0), np.zeros(0))
    for group in structure_of(robot).supplies:
        drive, at = robot.drives[group[0]], axes.index(group[0])
        motor, supply = drive.motor, drive.supply
        if not below[at] > 0.0 or supply is None or not isinstance(motor, Hydraulic):
            continue
        tick, pressure = int(ticks[at]), float(supply_floor(drive) - below[at])
        back = motor.return_pressure
        what = (
            f"below its return, {back / _BAR:.4g} bar"
            if pressure < back
            else f"its accumulator is empty below {supply.precharge / _BAR:.4g} bar"
        )
        names = ", ".join(f"`{robot.axis_joints[axis].name}`" for axis in group)
        found.append(
            SUPPLY_DRAINED.at(
                station.span_at(tick),
                f"supply `{supply.name}` of {plural(len(group), 'joint')} {names} comes down to "
                f"{pressure / _BAR:.4g} bar of {motor.supply_pressure / _BAR:.4g}: {what}",
                label=f"at t = {tick / station.hz:.2f} s",
                hint="lower the speed here, move fewer axes at once, or raise `pump_flow` or `gas_volume`",
                data={
                    "supply": supply.name,
                    "value": pressure,
                    "limit": supply_floor(drive),
                    "time_s": tick / station.hz,
                },
            )
        )
    return tuple(found)


def torn_oil(station: FinishedStation) -> tuple[Diagnostic, ...]:
    """Return S752 for each chamber in which the oil would have been pulled apart, where that was worst."""
    robot, tally = station.robot, station.tally
    found = []
    for name, least in floors(structure_of(robot).drives).items():
        axes = tally.axes(BELOW + name)
        if not axes or name == SUPPLY.name:
            continue
        below, ticks = tally.worst(BELOW + name)
        for at in np.flatnonzero(below > 0.0):
            joint, tick = axes[at], int(ticks[at])
            pressure = float(least - below[at])
            axis = robot.axis_joints[joint].name
            found.append(
                OIL_TORN.at(
                    station.span_at(tick),
                    f"{name.replace('pressure_', 'chamber ')} of joint `{axis}` would have come to "
                    f"{pressure / _BAR:.4g} bar, its oil gives way at {least / _BAR:.4g} bar",
                    label=f"at t = {tick / station.hz:.2f} s",
                    hint=station.circumstances(tick).hint(
                        "lower the speed or acceleration here, or give the drive a higher return pressure"
                    ),
                    data={"joint": joint + 1, "value": pressure, "limit": least, "time_s": tick / station.hz},
                )
            )
    return tuple(found)
