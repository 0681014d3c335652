"""Efforts at the axes from outside: for every sort of arm they do what their accelerations say."""

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.dynamics import mass_matrix
from ropsim.model import Payload, Rates, RobotModel
from ropsim.simulation import Servo
from ropsim.simulation.testing import constant
from support.arms import drive, random_arm
from support.closed_arms import COUPLED_PALLETIZER, palletizer
from support.servo_cases import controller

TICKS = 5
HZ = 10_000
"""So that a tick is too short for friction and drives."""
BOX = Payload(2.0, np.array([0.1, 0.0, 0.2]), np.diag([0.1, 0.2, 0.15]))


def _of(types: str) -> RobotModel:
    return random_arm(7, types, (drive(),) * len(types))


ARMS = {
    "plain": _of("RPR"),
    "long": _of("RRP" * 5),
    "closed": palletizer(),
    "coupled": COUPLED_PALLETIZER,
}


def _speeds(robot: RobotModel, effort: float) -> np.ndarray:
    servo = Servo.build(robot, controller(robot.n, Rates(HZ)), None, Engine.PYTHON, outside_rows=1)
    state = servo.initial_state(robot.home, BOX)
    pressed = state.pressed(effort * np.arange(1.0, robot.n + 1.0))
    return servo.run(pressed, constant(robot.home, 1), BOX, servo.recorder(state)).qd


@pytest.mark.parametrize("name", ARMS)
def test_efforts_from_outside_accelerate_an_arm_by_its_mass_matrix(name: str) -> None:
    """What they add to the speeds after a tick is M⁻¹·τ·T; friction and drives hardly change it."""
    robot = ARMS[name]
    found = (_speeds(robot, 1e-3) - _speeds(robot, -1e-3)) / 2e-3
    wanted = np.linalg.solve(mass_matrix(robot, robot.home, BOX), np.arange(1.0, robot.n + 1.0)) / HZ
    assert found == pytest.approx(wanted, rel=0.02, abs=0.005 * np.abs(wanted).max())


def test_efforts_from_outside_are_held_and_belong_to_the_state() -> None:
    robot = ARMS["plain"]
    servo = Servo.build(robot, controller(robot.n), None, Engine.PYTHON, outside_rows=1)
    state = servo.initial_state(robot.home, BOX).pressed(np.array([1.0, -2.0, 3.0]))
    whole = servo.run(state, constant(robot.home, TICKS), BOX, servo.recorder(state))
    cut = state
    for _ in range(TICKS):
        cut = servo.run(cut, constant(robot.home, 1), BOX, servo.recorder(cut))
    assert np.array_equal(whole.values, cut.values)
    assert whole.values[whole.layout.outside].tolist() == [1.0, -2.0, 3.0]


def test_an_arm_on_which_nothing_presses_has_the_same_bits_with_room_for_it() -> None:
    robot = ARMS["plain"]
    ends = []
    for rows in (0, 1):
        servo = Servo.build(robot, controller(robot.n), None, Engine.PYTHON, outside_rows=rows)
        state = servo.initial_state(robot.home + 0.1, BOX)
        after = servo.run(state, constant(robot.home, 20), BOX, servo.recorder(state))
        ends.append((after.q, after.qd, servo.efforts(after)))
    assert all(np.array_equal(one, other) for one, other in zip(*ends, strict=True))
