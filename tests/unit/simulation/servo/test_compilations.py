"""What a change compiles: structure does, numbers do not."""

import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from unittest.mock import patch

import numpy as np
import pytest

from ropsim import robots
from ropsim.codegen.testing import compiled
from ropsim.model import ControllerModel, Friction, Payload, Rates, RobotModel
from ropsim.simulation import Servo, ServoState
from support.dc_drives import dc_motor
from support.gains import cascaded
from support.servo_cases import START, puma, standing

Arm = tuple[RobotModel, ControllerModel]


def _heavier(arm: Arm) -> Arm:
    robot, _ = arm
    links = tuple(replace(link, mass=1.1 * link.mass) for link in robot.links)
    changed = replace(robot, links=links)
    return changed, robots.cascaded_controller(changed, Rates())


def _worn(arm: Arm) -> Arm:
    robot, model = arm
    drives = tuple(replace(one, friction=Friction(1e-3, 0.4, -0.5)) for one in robot.drives)
    return replace(robot, drives=drives), model


def _rewound(arm: Arm) -> Arm:
    robot, model = arm
    drives = tuple(replace(one, motor=replace(dc_motor(one), torque_constant=0.3)) for one in robot.drives)
    return replace(robot, drives=drives), model


def _tuned(arm: Arm) -> Arm:
    robot, model = arm
    return robot, replace(model, gains=replace(cascaded(model), kv=1.2 * cascaded(model).kv))


def _compilations(robot: RobotModel, model: ControllerModel, payload: Payload) -> tuple[int, ServoState]:
    """Return how often code was asked for while an arm stood still for a while, and its state."""
    with patch("ropsim.codegen.load.compiled", wraps=compiled) as asked:
        servo = Servo.build(robot, model)
        start = servo.initial_state(START, payload)
        after = servo.run(start, standing(START + 0.01, 20), payload, servo.recorder(start))
    return asked.call_count, after


CHANGES: list[Callable[[Arm], Arm]] = [_heavier, _worn, _rewound, _tuned]


@pytest.mark.parametrize("change", CHANGES)
def test_a_changed_number_compiles_nothing_and_changes_the_motion(change: Callable[[Arm], Arm]) -> None:
    _, before = _compilations(*puma(), Payload())
    count, after = _compilations(*change(puma()), Payload())
    assert count == 0
    assert (after.values != before.values).any()


def test_a_payload_compiles_nothing_and_changes_the_motion() -> None:
    _, before = _compilations(*puma(), Payload())
    count, after = _compilations(*puma(), Payload(2.0, np.array([0.0, 0.0, 0.1])))
    assert count == 0
    assert (after.values != before.values).any()


def test_another_structure_is_compiled() -> None:
    robot, model = puma()
    _compilations(robot, model, Payload())
    first, second, *others = robot.joints
    moved = replace(robot, joints=(first, replace(second, offset=0.01), *others))
    count, _ = _compilations(moved, model, Payload())
    assert count == 1


def test_where_an_upright_axis_has_its_zero_is_the_same_structure() -> None:
    robot, model = puma()
    _compilations(robot, model, Payload())
    turned = replace(robot, joints=(replace(robot.joints[0], offset=0.01), *robot.joints[1:]))
    count, _ = _compilations(turned, model, Payload())
    assert count == 0


def test_a_warm_process_simulates_without_numba(servo_script: str) -> None:
    """The first process compiles where the cache is empty; its code stands alone for the next one."""
    answers = [
        subprocess.run(
            [sys.executable, "-c", servo_script], capture_output=True, text=True, check=True
        ).stdout
        for _ in range(2)
    ]
    assert answers[1].split() == ["False"]


@pytest.fixture
def servo_script() -> str:
    return (
        f"import sys; sys.path[:0] = {sys.path!r}\n"
        "from support.servo_cases import START, puma, standing\n"
        "from ropsim.model import Payload\n"
        "from ropsim.simulation import Servo\n"
        "servo = Servo.build(*puma())\n"
        "state = servo.initial_state(START)\n"
        "servo.run(state, standing(START, 3), Payload(), servo.recorder(state))\n"
        "print('numba' in sys.modules)\n"
    )
