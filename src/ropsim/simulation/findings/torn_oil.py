"""Violations of oil pressure in hydraulic drives: pressures that no oil can have."""

import numpy as np

from ropsim.core import Diagnostic
from ropsim.dynamics import structure_of
from ropsim.simulation.diagnostics.limit_diagnostics import OIL_TORN
from ropsim.simulation.findings.finished_station import FinishedStation
from ropsim.simulation.servo.judged import BELOW
from ropsim.simulation.servo.log import floors

_BAR = 1e5


def torn_oil(station: FinishedStation) -> tuple[Diagnostic, ...]:
    """Return S752 for each chamber in which the oil would have been pulled apart, where that was worst."""
    robot, tally = station.robot, station.tally
    found = []
    for name, least in floors(structure_of(robot).drives).items():
        axes = tally.axes(BELOW + name)
        if not axes:
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
                    hint="lower the speed or acceleration here, or give the drive a higher return pressure",
                    data={"joint": joint + 1, "value": pressure, "limit": least, "time_s": tick / station.hz},
                )
            )
    return tuple(found)
