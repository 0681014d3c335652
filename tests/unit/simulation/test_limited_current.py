"""What a run tells of motors that have too little current for their program."""

from dataclasses import replace

import numpy as np
import pytest

import ropsim
from ropsim import robots
from ropsim.flow import Recording
from ropsim.model import CurrentLimitedAmplifier, Friction, Rates, RobotModel, Tool, VoltageAmplifier
from ropsim.simulation import RunOptions, run
from ropsim.workbench import environment_of
from support.cells import one_station

PUMA = robots.load("puma560")
AMPERES = 5.0
"""Of joint 2: its planner keeps the move within it but for friction, which takes up to 2.6 A more."""
COULOMB = 0.5
"""Of joint 2, at the motor [N·m]: four times as much as it had when it was new."""
TEXT = """\
program p
units mm, deg, s
set speed 10 %
mov (450, 0, 300)
set speed 100 %
mov (450, 0, 800)
"""


def _ran(kind: type[VoltageAmplifier] | type[CurrentLimitedAmplifier]) -> Recording:
    known = PUMA.drives[1].friction
    friction = Friction(known.viscous, COULOMB, -COULOMB, known.smoothing_speed)
    limited = replace(PUMA.drives[1], amplifier=kind(40.0, AMPERES), friction=friction)
    robot: RobotModel = replace(PUMA, drives=(PUMA.drives[0], limited, *PUMA.drives[2:]))
    model = robots.cascaded_controller(PUMA, Rates())
    cell = one_station("c", robot, model, tools={"": Tool("")}, start=robot.home)
    compiled = ropsim.language.compile(TEXT, environment_of(cell))
    assert compiled.icr is not None
    return run(cell, {"robot": compiled.icr}, RunOptions())


@pytest.fixture(scope="module")
def told() -> Recording:
    return _ran(VoltageAmplifier)


@pytest.fixture(scope="module")
def held() -> Recording:
    return _ran(CurrentLimitedAmplifier)


def _found(recording: Recording) -> list[tuple[str, int]]:
    return [(found.code, found.span.line if found.span else 0) for found in recording.findings]


def test_an_amplifier_without_a_limit_is_told_how_far_the_current_went(told: Recording) -> None:
    assert _found(told) == [("M563", 6), ("S731", 6)]
    assert np.abs(told.channels["current"].values[:, 1]).max() > 1.05 * AMPERES


def test_an_amplifier_with_a_limit_is_told_how_long_the_current_was_there(held: Recording) -> None:
    assert ("S739", 6) in _found(held)
    assert "S731" not in dict(_found(held))
    assert np.abs(held.channels["current"].values[:, 1]).max() <= AMPERES * (1 + 1e-12)


def test_with_less_torque_the_arm_falls_behind(told: Recording, held: Recording) -> None:
    worst = [np.abs(one.channels["q_error"].values[:, 1]).max() for one in (told, held)]
    assert worst[1] > 1.05 * worst[0]


def test_the_facts_name_the_limit(held: Recording) -> None:
    assert held.facts.stations[0].axes[1].max_current == AMPERES
