"""The example with hydraulic cylinders: no fault is found, and at rest the oil bears what gravity asks."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.codegen import Engine
from ropsim.dynamics import compiled
from ropsim.flow import Recording
from ropsim.model import Cell, HydraulicCylinder, combine

EXAMPLE = Path(__file__).parents[2] / "examples" / "crane"


@cache
def run_of() -> tuple[Cell, Recording]:
    project = ropsim.open(EXAMPLE)
    assert project.cell is not None
    return project.cell, project.simulate()


def test_there_is_nothing_to_find_fault_with() -> None:
    _, recording = run_of()
    assert recording.ok
    assert [str(found) for found in recording.findings] == []


@pytest.mark.parametrize("line", [10, 12, 14])
def test_where_the_crane_waits_the_pressures_hold_it_against_gravity(line: int) -> None:
    """Forces of both chambers differ by the load over its lever, to within what dry friction bears."""
    cell, recording = run_of()
    robot, channels = cell.stations["robot"].robot, recording.channels
    row = int(np.flatnonzero(channels["line"].values == line)[-1])
    q, a, b = (channels[name].values[row] for name in ("q", "pressure_a", "pressure_b"))
    load, rest = np.empty(2), np.zeros(2)
    tool = combine(cell.stations["robot"].tools["grapple"].loads)
    gravity = compiled(robot, tool, Engine.PYTHON).rigid_inverse
    gravity(np.array(q), rest, rest, np.zeros(6), load)
    for k, drive in enumerate(robot.drives):
        assert isinstance(drive.motor, HydraulicCylinder)
        force = drive.motor.area_a * a[k] - drive.motor.area_b * b[k]
        rub = drive.friction.coulomb_positive
        assert force == pytest.approx(load[k] / drive.ratio_at(float(q[k])), abs=1.3 * rub)
        assert abs(force) > 3.0 * rub
