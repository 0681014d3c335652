"""The functions for callers with plain arrays."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim import dynamics, kinematics, robots
from ropsim.codegen import Engine
from ropsim.model import DcMotor, IdealMotor, Payload, RobotModel
from support.arms import drive, random_arm, random_states

ROUNDING = 1e-11
TWO_ENGINES = 1e-12  # elementary functions of two libraries


@pytest.fixture(scope="module")
def puma() -> RobotModel:
    return robots.load("puma560")


def test_torques_split_into_mass_bias_and_friction(puma: RobotModel) -> None:
    for q, qd, qdd in random_states(puma, 20):
        parts = (
            dynamics.mass_matrix(puma, q) @ qdd + dynamics.bias(puma, q, qd) - dynamics.friction(puma, q, qd)
        )
        np.testing.assert_allclose(dynamics.inverse_dynamics(puma, q, qd, qdd), parts, rtol=0, atol=ROUNDING)


def test_forward_dynamics_with_a_payload_undo_inverse_dynamics_with_it(puma: RobotModel) -> None:
    payload = Payload(2.0, np.array([0.01, 0.02, 0.1]), np.diag([0.01, 0.02, 0.015]))
    for q, qd, qdd in random_states(puma, 20):
        tau = dynamics.inverse_dynamics(puma, q, qd, qdd, payload=payload)
        back = dynamics.forward_dynamics(puma, q, qd, tau, payload)
        np.testing.assert_allclose(back, qdd, rtol=0, atol=ROUNDING)


def test_both_engines_agree(puma: RobotModel) -> None:
    for q, qd, tau in random_states(puma, 20):
        results = []
        for engine in Engine:
            qdd = np.empty(6)
            dynamics.compiled(puma, engine=engine).forward(np.array(q), np.array(qd), np.array(tau), qdd)
            results.append(qdd)
        np.testing.assert_allclose(results[0], results[1], rtol=TWO_ENGINES, atol=TWO_ENGINES)


def test_a_wrong_shape_names_array_shape_and_what_is_allowed(puma: RobotModel) -> None:
    with pytest.raises(
        dynamics.StateShapeError, match=r"`qd` has shape `\(5,\)`; allowed is `\(6,\)`"
    ) as caught:
        dynamics.bias(puma, np.zeros(6), np.zeros(5))
    assert caught.value.diagnostic.code == "M570"


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_number_that_is_none_is_refused(puma: RobotModel, bad: float) -> None:
    rest, odd = np.zeros(6), np.array([0.0, 0.0, bad, 0.0, 0.0, 0.0])
    with pytest.raises(kinematics.NotFiniteError, match="`qdd`"):
        dynamics.inverse_dynamics(puma, rest, rest, odd)
    with pytest.raises(kinematics.NotFiniteError, match="`tau`"):
        dynamics.forward_dynamics(puma, rest, rest, odd)


def test_a_wrench_needs_six_numbers(puma: RobotModel) -> None:
    rest = np.zeros(6)
    with pytest.raises(dynamics.StateShapeError, match="`wrench`"):
        dynamics.inverse_dynamics(puma, rest, rest, rest, [1.0, 2.0, 3.0])


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"joints": (), "links": ()}, "has no joints"),
        ({"links": ()}, "has 0 links for 2 joints"),
        ({"drives": (drive(),)}, "has 1 drives for 2 joints"),
    ],
)
def test_lists_that_do_not_go_together_are_refused(change: dict[str, Any], told: str) -> None:
    robot = replace(random_arm(0, "RR"), **change)
    with pytest.raises(dynamics.JointCountError, match=told) as caught:
        dynamics.gravity(robot, np.zeros(robot.n))
    assert caught.value.diagnostic.code == "M573"


def test_a_drive_that_cannot_exist_is_refused() -> None:
    robot = robots.load("puma560")
    first = robot.drives[0]
    assert isinstance(first.motor, DcMotor)
    for motor, what in (
        (replace(first.motor, torque_constant=0.0), "`torque_constant` of the drive of joint `1`"),
        (replace(first.motor, resistance=-1.0), "`resistance`"),
        (IdealMotor(), "takes effort"),
    ):
        odd = replace(robot, drives=(replace(first, motor=motor), *robot.drives[1:]))
        with pytest.raises(dynamics.ModelNumberError, match=what) as caught:
            dynamics.gravity(odd, np.zeros(6))
        assert caught.value.diagnostic.code == "M572"


def test_inputs_are_not_changed(puma: RobotModel) -> None:
    q, qd, qdd = random_states(puma, 1)[0]
    before = q.copy(), qd.copy(), qdd.copy()
    dynamics.inverse_dynamics(puma, q, qd, qdd)
    np.testing.assert_array_equal((q, qd, qdd), before)


def test_equal_models_share_what_was_made_for_one_of_them() -> None:
    one, other = random_arm(5, "RRR"), random_arm(5, "RRR")
    assert one is not other
    assert dynamics.compiled(one, engine=Engine.PYTHON) is dynamics.compiled(other, engine=Engine.PYTHON)
    heavier = replace(other, links=(replace(other.links[0], mass=9.0), *other.links[1:]))
    assert dynamics.compiled(one, engine=Engine.PYTHON) is not dynamics.compiled(
        heavier, engine=Engine.PYTHON
    )
