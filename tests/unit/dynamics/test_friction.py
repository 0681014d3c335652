"""Friction of a drive."""

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.dynamics import compiled, friction
from ropsim.model import Friction, RobotModel
from ropsim.spatial import Array
from support.arms import drive, random_arm

ASYMMETRIC = Friction(viscous=3.0, coulomb_positive=2.0, coulomb_negative=-1.0)


def _arm(ratio: float) -> RobotModel:
    return random_arm(0, "R", (drive(ratio=ratio, friction=ASYMMETRIC),))


@pytest.mark.parametrize("ratio", [2.0, -2.0])
def test_friction_acts_against_the_motion_whatever_the_sign_of_the_gear(ratio: float) -> None:
    robot = _arm(ratio)
    assert friction(robot, [0.0], [1.0])[0] == pytest.approx(-(3.0 * 4.0 * 1.0 + 2.0 * 2.0))
    assert friction(robot, [0.0], [-1.0])[0] == pytest.approx(3.0 * 4.0 * 1.0 + 2.0 * 1.0)


def test_friction_is_continuous_at_standstill() -> None:
    robot = _arm(2.0)
    assert friction(robot, [0.0], [0.0])[0] == 0.0
    assert abs(friction(robot, [0.0], [1e-9])[0] - friction(robot, [0.0], [-1e-9])[0]) < 1e-5


@pytest.mark.parametrize("speed", [-2.0, -1e-3, 0.0, 1e-3, 2.0])
def test_the_generated_code_and_the_function_mean_the_same_friction(speed: float) -> None:
    robot = _arm(2.0)
    functions = compiled(robot, engine=Engine.PYTHON)

    def torque(name: str) -> Array:
        tau = np.empty(1)
        zero = np.zeros(1)
        arguments = (zero, np.array([speed]), zero, np.zeros(6), tau)
        getattr(functions, name)(*arguments)
        return tau

    spent = torque("inverse") - torque("rigid_inverse")
    np.testing.assert_allclose(spent, -friction(robot, [0.0], [speed]), rtol=1e-12, atol=1e-12)


def test_an_arm_without_drives_has_no_friction() -> None:
    assert friction(random_arm(0, "RR"), [0.3, 0.2], [1.0, -1.0]).tolist() == [0.0, 0.0]
