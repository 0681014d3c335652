"""Springs and dampers in the equations of motion: forces are slopes of their energy, dampers take power."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.dynamics import (
    bias,
    forward_dynamics,
    gravity,
    inverse_dynamics,
    mass_matrix,
)
from ropsim.kinematics import joint_frames
from ropsim.model import BASE_LINK, JointSpring, RobotModel, Spring, coordinates
from ropsim.spatial import Array
from support.arms import random_arm
from support.trees import random_tree

STEP = 1e-6
SPRINGS = (
    Spring("balance", BASE_LINK, np.array([0.3, -0.2, 0.4]), 2, np.array([0.1, 0.2, 0.1]), 900.0, 0.25, 4.0),
    Spring("between", 3, np.array([0.0, 0.1, 0.2]), 1, np.array([-0.2, 0.1, 0.0]), 500.0, 0.0, 0.0),
)
ON_JOINTS = (JointSpring("first", 0, 40.0, 0.3, 0.0), JointSpring("third", 2, 25.0, -0.2, 1.5))
PLAIN = (random_arm(4, "RPRR"), random_tree(3, 5).robot)
SPRUNG = tuple(replace(one, springs=SPRINGS, joint_springs=ON_JOINTS) for one in PLAIN)
PAIRS = list(zip(PLAIN, SPRUNG, strict=True))


def lengths(robot: RobotModel, q: Array) -> Array:
    frames = [*joint_frames(robot, q)[:-1], np.eye(4)]

    def place(link: int, point: Array) -> Array:
        return np.asarray(frames[link][:3, :3] @ point + frames[link][:3, 3])

    return np.array(
        [np.linalg.norm(place(s.link_2, s.point_2) - place(s.link_1, s.point_1)) for s in robot.springs]
    )


def energy(robot: RobotModel, q: Array) -> float:
    """Return what springs have stored [J]."""
    made = coordinates(robot)
    places = made.T @ q + made.c
    between = sum(
        0.5 * s.stiffness * (one - s.free_length) ** 2
        for s, one in zip(robot.springs, lengths(robot, q), strict=True)
    )
    on = sum(0.5 * s.stiffness * (places[s.coordinate] - s.rest) ** 2 for s in robot.joint_springs)
    return float(between + on)


@pytest.mark.parametrize(("plain", "sprung"), PAIRS, ids=["arm", "tree"])
def test_what_holds_an_arm_is_the_slope_of_the_energy_of_its_springs(
    plain: RobotModel, sprung: RobotModel
) -> None:
    rng = np.random.default_rng(1)
    for q in rng.uniform(-1.0, 1.0, (5, plain.n)):
        slope = [
            (energy(sprung, q + h) - energy(sprung, q - h)) / (2.0 * STEP) for h in STEP * np.eye(plain.n)
        ]
        assert gravity(sprung, q) - gravity(plain, q) == pytest.approx(np.array(slope), rel=1e-6, abs=1e-6)


@pytest.mark.parametrize(("plain", "sprung"), PAIRS, ids=["arm", "tree"])
def test_dampers_take_the_power_of_their_speeds(plain: RobotModel, sprung: RobotModel) -> None:
    rng = np.random.default_rng(2)
    made = coordinates(plain)
    for q, qd in rng.uniform(-1.0, 1.0, (5, 2, plain.n)):
        static = gravity(sprung, q) - gravity(plain, q)
        against = bias(sprung, q, qd) - bias(plain, q, qd) - static
        rates = (lengths(sprung, q + STEP * qd) - lengths(sprung, q - STEP * qd)) / (2.0 * STEP)
        taken = sum(s.damping * rate**2 for s, rate in zip(SPRINGS, rates, strict=True))
        taken += sum(s.damping * (made.T @ qd)[s.coordinate] ** 2 for s in ON_JOINTS)
        assert qd @ against == pytest.approx(taken, rel=1e-6)
        assert taken > 0.0


@pytest.mark.parametrize("sprung", SPRUNG, ids=["arm", "tree"])
def test_forward_dynamics_undoes_inverse_dynamics_with_springs(sprung: RobotModel) -> None:
    q, qd, qdd = np.random.default_rng(3).uniform(-1.0, 1.0, (3, sprung.n))
    tau = inverse_dynamics(sprung, q, qd, qdd)
    assert forward_dynamics(sprung, q, qd, tau) == pytest.approx(qdd, rel=1e-9, abs=1e-9)
    without = replace(sprung, springs=(), joint_springs=())
    assert np.array_equal(mass_matrix(sprung, q), mass_matrix(without, q))


def test_a_spring_without_length_has_no_force() -> None:
    """Its ends coincide on the axis of the first joint, where they stay."""
    arm, on_axis = random_arm(5, "RR"), np.array([0.0, 0.0, 0.3])
    place = joint_frames(arm, [0.0, 0.0])[0][:3] @ np.array([*on_axis, 1.0])
    spring = Spring("folded", BASE_LINK, place, 0, on_axis, 1000.0, 0.1, 10.0)
    q, qd = np.array([0.4, -0.3]), np.array([1.0, 2.0])
    assert np.abs(lengths(replace(arm, springs=(spring,)), q)).max() < 1e-15
    assert bias(replace(arm, springs=(spring,)), q, qd) == pytest.approx(bias(arm, q, qd), abs=1e-12)


def test_a_zero_free_length_spring_balances_a_pendulum() -> None:
    """D. A. Streit, B. J. Gilmore: Perfect spring equilibrators for rotatable bodies, 1989: k·a·b = m·g·l."""
    arm = random_arm(6, "R")
    joint = replace(arm.joints[0], placement=type(arm.joints[0].placement)(), offset=0.0)
    link = replace(arm.links[0], mass=3.0, com=np.array([0.4, 0.0, 0.0]))
    arm = replace(arm, joints=(joint,), links=(link,), gravity=np.array([0.0, -9.81, 0.0]))
    a, b = 0.3, 0.25
    spring = Spring(
        "balance", BASE_LINK, np.array([0.0, a, 0.0]), 0, np.array([b, 0.0, 0.0]), 3.0 * 9.81 * 0.4 / (a * b)
    )
    balanced = replace(arm, springs=(spring,))
    for angle in np.linspace(-3.0, 3.0, 13):
        assert abs(gravity(balanced, [angle])[0]) < 1e-12
    assert abs(gravity(arm, [0.1])[0]) > 10.0
