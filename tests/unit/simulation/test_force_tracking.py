"""A force held by a sensor: the gain beyond which it swings, in closed form.

At each interpolation tick T the speed of the shift becomes k·(measured - wanted), and it changes evenly in
the tick. With a sensor d ticks late and a contact of stiffness K the loop is
a·(z + 1) / (2·z^(d + 1)·(z - 1)), a = k·K·T. On the unit circle (z + 1)/(z - 1) = -j·cot(θ/2), so the phase
is -π at θ = π/(2·(d + 1)), and the loop is stable for a < 2·tan(π/(4·(d + 1))).
"""

import math
from functools import cache

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import Fidelity
from ropsim.model import Box, Cell, FixedObject, ForceSensor, SensorErrors, Shape, Signal, Tool
from ropsim.simulation import RunOptions, run
from ropsim.spatial import Array, Pose
from support.cells import one_station
from support.compiled import code_of

ROBOT = robots.load("puma560")
TICK = 4e-3
STIFFNESS = 2e4
TOP, WANTED, DEPTH = 0.1, 15.0, 15.05 / STIFFNESS
"""Height of the table [m], wanted force [N], depth of the path in it [m]."""
FIRST = STIFFNESS * DEPTH - WANTED
"""Error of the force at the beginning [N]; speed and acceleration of the shift stay within their limits."""


@cache
def cell_with(delay: float) -> Cell:
    sensor = ForceSensor("", STIFFNESS, 0.01, SensorErrors(delay=delay))
    table = FixedObject("table", Pose(np.array([0.5, 0.0, TOP / 2.0])), (Shape(Box((0.6, 1.0, TOP))),))
    return one_station(
        "c",
        ROBOT,
        robots.default_controller("puma560"),
        tools={"": Tool("")},
        start=ROBOT.home,
        signals={"force": Signal("force", is_input=True, analog=True, sensor=sensor)},
        objects=(table,),
    )


@cache
def errors(ticks: int, share: float) -> Array:
    """Errors of the force at the interpolation ticks of a path, at a share of the bound of the gain [N]."""
    gain = share * 2.0 * math.tan(math.pi / (4.0 * (ticks + 1))) / (STIFFNESS * TICK)
    cell, z = cell_with(ticks * TICK), 1e3 * (TOP - DEPTH)
    lines = (
        f"mov (460, 0, {z})",
        f"lin (500, 0, {z}) speed 20 mm/s track force = 15 N along -z gain {gain:.9f}",
    )
    recording = run(cell, {"robot": code_of(cell, *lines)}, RunOptions(Fidelity.KINEMATIC, record_hz=250))
    shift = recording.rows("correction")
    on_path = shift[~np.isnan(shift)]
    found: Array = STIFFNESS * (DEPTH - on_path) - WANTED
    return found[: round(1.5 / TICK)]


DELAYS = pytest.mark.parametrize("ticks", [0, 1, 3, 6])


@DELAYS
def test_below_the_bound_the_error_dies_away(ticks: int) -> None:
    found = errors(ticks, 0.85)
    assert found[0] > 0.5 * FIRST
    assert np.abs(found[-50:]).max() < 0.05 * FIRST


@DELAYS
def test_beyond_the_bound_it_swings_and_grows(ticks: int) -> None:
    found = errors(ticks, 1.15)
    assert np.abs(found[-50:]).max() > 2.0 * FIRST
    assert found[-50:].min() < -FIRST


@DELAYS
def test_a_third_over_stiffness_and_delay_does_not_swing(ticks: int) -> None:
    """The rule of the manual: gain = 1/(3·K·t), t the time from a sample to the end of its tick."""
    bound = 2.0 * math.tan(math.pi / (4.0 * (ticks + 1)))
    found = errors(ticks, 1.0 / (3.0 * (ticks + 1)) / bound)
    assert found.min() > -0.02 * FIRST
    assert np.abs(found[-50:]).max() < 1e-3 * FIRST
