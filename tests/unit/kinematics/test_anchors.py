"""Anchors of an arm of seven axes: answers with a joint at either of its limits are among them."""

import numpy as np
import pytest

from ropsim.kinematics import forward_batch, redundant_solver_of
from ropsim.kinematics.testing import narrow_limits
from ropsim.spatial import Array
from support.redundant_poses import seven_axis_arms

ARMS = seven_axis_arms()
NEAR = 1e-6
"""The answers of an elimination are polished to the pose [rad]."""


@pytest.mark.parametrize("name", ["random 0", "narrow 1", "narrow 5"])
@pytest.mark.parametrize("side", [0, 1], ids=["lower", "upper"])
def test_an_answer_with_a_joint_at_a_limit_is_an_anchor(name: str, side: int) -> None:
    robot = ARMS[name]
    solver = redundant_solver_of(robot)
    assert solver is not None
    assert solver.name == "general seven-axis"
    random = np.random.default_rng(4)
    lower = np.maximum(robot.lower_limits, -np.pi)
    upper = np.minimum(robot.upper_limits, np.pi)
    limits = narrow_limits(np.array([lower, upper, np.ones(7)]))
    for joint in range(7):
        q = random.uniform(0.9 * lower + 0.1 * upper, 0.1 * lower + 0.9 * upper)
        q[joint] = limits[side, joint]
        (X,) = forward_batch(robot, q[np.newaxis])
        assert nearest(solver.anchors(X, limits[:2]), q) < NEAR, joint


def nearest(rows: Array, q: Array) -> float:
    """Return how far the nearest of some rows is from q, whole turns apart [rad]."""
    away = np.abs((rows - q + np.pi) % (2.0 * np.pi) - np.pi)
    return float(away.max(axis=1).min())
