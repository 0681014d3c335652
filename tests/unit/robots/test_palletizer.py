"""The palletizer: its parallelograms close, its flange stays level, its motors feel the weight."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.codegen import Engine
from ropsim.dynamics import compiled, gravity
from ropsim.kinematics import configurations, forward_batch, frames_batch, inverse_batch, solver_of
from ropsim.model import Payload, coordinates
from ropsim.robots.palletizer_shapes import CRANK, FOREARM, LOWER_ARM, PIN
from ropsim.spatial import Array
from support.mujoco_tree import MujocoTree

ROBOT = robots.load("palletizer")
LEVEL = 1e-9  # [rad]
CLOSED = 1e-12  # [m]
WORK = 1e-9  # of torques of some thousand N·m
NAMES = [joint.name for joint in ROBOT.joints]
ANYWHERE = np.random.default_rng(4).uniform(-np.pi, np.pi, (50, 4))


def points(name: str, x: float, y: float = 0.0) -> Array:
    """Return where a point of a link is for all configurations, shape (50, 3)."""
    frames = frames_batch(ROBOT, ANYWHERE)[:, NAMES.index(name)]
    return np.asarray(frames @ np.array([x, y, 0.0, 1.0]))[:, :3]


def test_the_flange_is_level_whatever_the_axes_do() -> None:
    down = forward_batch(ROBOT, ANYWHERE)[:, :3, 2]
    assert np.arccos(np.clip(-down[:, 2], -1.0, 1.0)).max() < 1e-7  # the cosine is flat here
    assert np.linalg.norm(down[:, :2], axis=1).max() < LEVEL


@pytest.mark.parametrize(
    ("rod", "length", "held_by", "x", "y"),
    [
        ("rod", LOWER_ARM, "elbow", -CRANK, 0.0),
        ("lower link", LOWER_ARM, "triangle", *PIN),
        ("upper link", FOREARM, "wrist", *PIN),
    ],
)
def test_each_rod_ends_at_the_pin_that_holds_it(
    rod: str, length: float, held_by: str, x: float, y: float
) -> None:
    np.testing.assert_allclose(points(rod, length), points(held_by, x, y), rtol=0, atol=CLOSED)


def test_motor_torques_do_the_work_of_the_free_tree_in_another_engine() -> None:
    oracle, made = MujocoTree(ROBOT), coordinates(ROBOT)
    functions, rng = compiled(ROBOT, engine=Engine.PYTHON), np.random.default_rng(1)
    tau = np.empty(4)
    for q, qd, qdd in rng.uniform(-2.0, 2.0, (10, 3, 4)):
        functions.rigid_inverse(q, qd, qdd, np.zeros(6), tau)
        at_joints = oracle.inverse(made.T @ q + made.c, made.T @ qd, made.T @ qdd)
        scale = np.abs(at_joints).max()
        np.testing.assert_allclose(tau, made.T.T @ at_joints, rtol=0, atol=WORK * scale)


def test_the_weight_of_a_load_is_shared_by_lower_arm_and_crank() -> None:
    """Statics of the two parallelograms by hand: m·g·L·cos of the angle of each link."""
    q = ROBOT.home
    load = Payload(100.0)
    felt = gravity(ROBOT, q, load) - gravity(ROBOT, q)
    weight = 100.0 * 9.81
    expected = [0.0, weight * LOWER_ARM * np.cos(q[1]), weight * FOREARM * np.cos(q[2]), 0.0]
    np.testing.assert_allclose(felt, expected, rtol=0, atol=1e-8)


def test_every_configuration_is_found_again_in_closed_form() -> None:
    Q = configurations(ROBOT, 200)
    poses = forward_batch(ROBOT, Q)
    found = inverse_batch(ROBOT, poses)
    assert (solver_of(ROBOT).name, found.shape[1]) == ("level wrist", 4)
    apart = found - Q[:, np.newaxis]
    apart -= 2.0 * np.pi * np.round(apart / (2.0 * np.pi))
    assert np.nanmin(np.abs(apart).max(axis=2), axis=1).max() < 1e-9
    for row in range(4):
        there = ~np.isnan(found[:, row, 0])
        assert there.any()
        reached = forward_batch(ROBOT, found[there, row])
        np.testing.assert_allclose(reached, poses[there], rtol=0, atol=1e-9)
