"""The arm against MuJoCo, an engine that shares nothing with ours."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.codegen import Engine
from ropsim.dynamics import compiled, forward_dynamics, rigid_inverse_dynamics
from ropsim.model import DcMotor, Friction, RobotModel
from support.arms import drive, random_arm, random_states
from support.mujoco_arm import MujocoArm

AGREEMENT = 1e-9  # torques up to 1e3 and accelerations up to 1e3 in double arithmetic


def _frictionless_puma() -> RobotModel:
    puma = robots.load("puma560")
    drives = tuple(replace(one, friction=Friction(0.0, 0.0, 0.0)) for one in puma.drives)
    return replace(puma, drives=drives)


def test_puma_inverse_dynamics_agree_with_mujoco() -> None:
    puma = replace(robots.load("puma560"), drives=())
    oracle = MujocoArm(puma)
    for q, qd, qdd in random_states(puma, 50):
        ours = rigid_inverse_dynamics(puma, q, qd, qdd)
        np.testing.assert_allclose(ours, oracle.inverse(q, qd, qdd), rtol=0, atol=AGREEMENT)


def test_puma_forward_dynamics_with_motor_inertia_agree_with_mujoco() -> None:
    puma = _frictionless_puma()
    oracle = MujocoArm(puma)
    for q, qd, tau in random_states(puma, 50):
        ours = forward_dynamics(puma, q, qd, 10.0 * tau)
        np.testing.assert_allclose(ours, oracle.forward(q, qd, 10.0 * tau), rtol=1e-9, atol=AGREEMENT)


@pytest.mark.parametrize("types", ["RPR", "PPR", "RPRPRP", "RRRRRRR"])
def test_arms_with_prismatic_joints_agree_with_mujoco(types: str) -> None:
    motor = DcMotor(0.2, 0.2, 2.0, 1e-3, 1e-4)
    robot = random_arm(11, types, (drive(ratio=30.0, motor=motor),) * len(types))
    oracle = MujocoArm(robot)
    functions = compiled(robot, engine=Engine.PYTHON)
    for q, qd, tau in random_states(robot, 10):
        qdd = np.empty(robot.n)
        functions.forward(q, qd, tau, qdd)
        np.testing.assert_allclose(qdd, oracle.forward(q, qd, tau), rtol=1e-9, atol=AGREEMENT)
