"""What a run tells of a motor that grows warm."""

from dataclasses import replace
from math import inf

import numpy as np
import pytest

import ropsim
from ropsim import robots
from ropsim.flow import Recording
from ropsim.model import DcMotor, GuardedAmplifier, Rates, RobotModel, ThermalDcMotor, Tool
from ropsim.simulation import RunOptions, run
from ropsim.workbench import environment_of
from support.cells import one_station

PUMA = robots.load("puma560")
START = 40.0
"""Of joint 2 over the surroundings [K], after some hours of work."""
TEXT = """\
program p
units mm, deg, s
set speed 10 %
mov (450, 0, 300)
set speed 100 %
mov (450, 0, 800)
"""


def ran(most: float) -> Recording:
    """Run with a sensor in the winding of joint 2 that reports a rise [K]."""
    known = PUMA.drives[1].motor
    assert isinstance(known, DcMotor)
    constants = (known.torque_constant, known.back_emf_constant, known.resistance, known.inductance)
    warm = ThermalDcMotor(*constants, known.rotor_inertia, 0.6, 1.4, 18.0, 900.0, start_rise=START)
    watched = replace(PUMA.drives[1], amplifier=GuardedAmplifier(40.0, inf, most), motor=warm)
    robot: RobotModel = replace(PUMA, drives=(PUMA.drives[0], watched, *PUMA.drives[2:]))
    model = robots.cascaded_controller(robot, Rates())
    cell = one_station("c", robot, model, tools={"": Tool("")}, start=robot.home)
    compiled = ropsim.language.compile(TEXT, environment_of(cell))
    assert compiled.icr is not None
    return run(cell, {"robot": compiled.icr}, RunOptions())


@pytest.fixture(scope="module")
def quiet() -> Recording:
    return ran(100.0)


def test_the_rises_are_recorded_and_begin_where_the_model_says(quiet: Recording) -> None:
    winding, housing = (quiet.channels[name] for name in ("winding_rise", "housing_rise"))
    assert winding.unit == "K"
    assert winding.values.shape[1] == 1
    assert winding.values[0, 0] == housing.values[0, 0] == START
    assert winding.values.max() > START + 0.05
    assert 0.0 < np.ptp(housing.values) < np.ptp(winding.values)
    assert not [one for one in quiet.findings if one.code == "S744"]


def test_a_winding_beyond_its_rise_is_told_at_the_line(quiet: Recording) -> None:
    most = 0.5 * (START + float(quiet.channels["winding_rise"].values.max()))
    (found,) = [one for one in ran(most).findings if one.code == "S744"]
    assert "winding_rise" in found.message
    assert " K" in found.message
    assert found.span
    assert found.span.line in (4, 6)
