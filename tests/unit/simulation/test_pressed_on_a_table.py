"""A force held against a table that pushes back, at the gain of the manual and far beyond it."""

from functools import cache

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import Recording
from ropsim.model import (
    Box,
    Cell,
    FixedObject,
    ForceTorqueSensor,
    MeantContact,
    Shape,
    Signal,
    Tool,
    WrenchAxis,
)
from ropsim.simulation import RunOptions, run
from ropsim.spatial import Array, Pose
from support.cells import one_station
from support.compiled import code_of

TOP, STIFFNESS, WANTED = 0.1, 1e5, 15.0
"""Height of the table [m], stiffness of the contact [N/m], wanted force [N]."""
LAG = 0.015
"""Of drives and arm, about [s]."""
RULE = 1.0 / (3.0 * STIFFNESS * (0.004 + LAG))
"""Gain of the manual [m/s for each newton]."""


def cell() -> Cell:
    tip = Shape(Box((0.02, 0.02, 0.08)), Pose(np.array([0.0, 0.0, 0.06])))
    tool = Tool("tip", X_MT=Pose(np.array([0.0, 0.0, 0.1])), mass=0.5, shapes=(tip,))
    table = FixedObject("table", Pose(np.array([0.5, 0.0, TOP / 2.0])), (Shape(Box((0.6, 1.0, TOP))),))
    sensor = ForceTorqueSensor("", WrenchAxis.Z)
    return one_station(
        "c",
        robots.load("puma560"),
        robots.default_controller("puma560"),
        tools={"tip": tool},
        default_tool="tip",
        signals={"fz": Signal("fz", is_input=True, analog=True, sensor=sensor)},
        objects=(table,),
        contacts=(MeantContact("press", "tip", ("table",), STIFFNESS, 200.0),),
    )


@cache
def pressed(share: float) -> Recording:
    """Run a path over the table, at a share of the gain of the rule."""
    lines = (
        "mov (500, 0, 110)",
        "lin (500, 0, 95) speed 5 mm/s until fz > 10 N",
        f"lin here offset (30, 0, 0) speed 15 mm/s track fz = 15 N along -z gain {share * RULE:.9f}",
    )
    here = cell()
    return run(here, {"robot": code_of(here, *lines)}, RunOptions(record_hz=1000))


def held(recording: Recording) -> Array:
    """Return the force of the second half of the path that is corrected [N]."""
    rows = np.flatnonzero(~np.isnan(recording.rows("correction")))
    found: Array = recording.rows("contact_wrench")[rows[len(rows) // 2 :], 2]
    return found


def test_at_the_gain_of_the_rule_the_force_is_held_and_does_not_swing() -> None:
    force = held(pressed(1.0))
    assert force.mean() == pytest.approx(WANTED, abs=0.05)
    assert force.std() < 0.1


def test_far_beyond_it_the_force_swings_without_end() -> None:
    """The rule leaves out that the arm gives way, too, so it takes more than five times of it to swing.

    How far it swings is bounded by the acceleration of the correction.
    """
    force = held(pressed(20.0))
    late = force[len(force) // 2 :] - WANTED
    assert late.std() > 0.4
    assert np.count_nonzero(np.diff(np.sign(late)) != 0) > 20


def test_the_sensor_reads_what_the_table_pushes() -> None:
    recording = pressed(1.0)
    channel, force = recording.channels["signal.fz"], recording.rows("contact_wrench")[:, 2]
    assert channel.times is not None
    ticks = np.round(channel.times * 1000).astype(int)
    assert channel.values == pytest.approx(force[ticks], rel=1e-3, abs=0.02)
