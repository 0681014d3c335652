"""Arms that are too long for straight-line code: the same dynamics as loops."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import dynamics
from ropsim.codegen import Engine
from ropsim.dynamics import ArmFunctions
from ropsim.dynamics.long_arms.long_arm import LongArmFunctions
from ropsim.flow import JointReference
from ropsim.model import Friction, Payload, Rates, RobotModel
from ropsim.simulation import Servo
from support.arms import drive, random_arm, random_states
from support.mujoco_arm import MujocoArm
from support.servo_cases import controller, quintic, with_rates

FRICTION = Friction(1e-3, 0.3, -0.2)
BOX = Payload(2.0, np.array([0.1, 0.0, 0.2]), np.diag([0.1, 0.2, 0.15]))
ROUNDING = 1e-12  # relative to the largest number


def _arm(types: str) -> RobotModel:
    return random_arm(7, types, (drive(friction=FRICTION),) * len(types))


def _close(one: np.ndarray, other: np.ndarray) -> None:
    np.testing.assert_allclose(one, other, rtol=0, atol=ROUNDING * np.abs(other).max())


@pytest.mark.parametrize("types", ["R", "P", "RR", "PR", "RPRPRP", "RRRRRRRRRRRR"])
def test_the_loops_agree_with_straight_line_code(types: str) -> None:
    robot = _arm(types)
    n, rng = robot.n, np.random.default_rng(1)
    straight, loops = (kind(robot, BOX, Engine.PYTHON) for kind in (ArmFunctions, LongArmFunctions))
    for q, qd, x in random_states(robot, 3):
        wrench = rng.normal(size=6)
        found: list[list[np.ndarray]] = []
        for functions in (straight, loops):
            tau, rigid, qdd, M = np.empty(n), np.empty(n), np.empty(n), np.empty(n * n)
            functions.inverse(q, qd, x, wrench, tau)
            functions.rigid_inverse(q, qd, x, wrench, rigid)
            functions.forward(q, qd, x, qdd)
            functions.mass_matrix(q, M)
            found.append([tau, rigid, qdd, M])
        for one, other in zip(*found, strict=True):
            _close(other, one)


@pytest.mark.parametrize("n", [13, 30, 100])
def test_forward_dynamics_undo_inverse_dynamics_at_any_length(n: int) -> None:
    robot = _arm(("RRP" * n)[:n])
    for q, qd, qdd in random_states(robot, 2):
        tau = dynamics.inverse_dynamics(robot, q, qd, qdd, payload=BOX)
        back = dynamics.forward_dynamics(robot, q, qd, tau, BOX)
        np.testing.assert_allclose(back, qdd, rtol=0, atol=1e-7)


def test_a_chain_of_fifty_agrees_with_another_engine() -> None:
    robot = random_arm(9, ("RRP" * 17)[:50], (drive(),) * 50)
    oracle = MujocoArm(robot)
    for q, qd, tau in random_states(robot, 3):
        qdd = dynamics.forward_dynamics(robot, q, qd, tau)
        expected = oracle.forward(q, qd, tau)
        np.testing.assert_allclose(qdd, expected, rtol=0, atol=1e-9 * np.abs(expected).max())


def test_a_long_arm_is_servoed_like_a_short_one() -> None:
    """Twelve joints by straight-line code, the same with a thirteenth of next to no mass, in equal steps."""
    short = _arm("R" * 12)
    tail = random_arm(8, "R", (drive(friction=FRICTION),))
    light = tail.links[0].__class__(1e-12, np.zeros(3), np.zeros((3, 3)))
    long_ = RobotModel(
        name="long",
        title="long",
        joints=(*short.joints, replace(tail.joints[0], name="13", parent=11)),
        links=(*short.links, light),
        drives=(*short.drives, *tail.drives),
        X_nM=tail.X_nM,
        home=np.zeros(13),
        gravity=short.gravity,
    )
    goal = np.full(13, 0.02)
    reference = quintic(np.zeros(13), goal, 15)
    first = JointReference(reference.q[:, :12], reference.qd[:, :12], reference.qdd[:, :12])
    ends = []
    for robot, follow in ((short, first), (long_, reference)):
        model = with_rates(controller(robot.n, kv=300.0), Rates(plant_steps=2))
        servo = Servo.build(robot, model, None, Engine.PYTHON)
        start = servo.initial_state(np.zeros(robot.n))
        ends.append(servo.run(start, follow, Payload(), servo.recorder(start)).q[:12])
    np.testing.assert_allclose(ends[1], ends[0], rtol=0, atol=1e-9)
