"""Forward and inverse kinematics of the PUMA 560."""

from typing import Any

import numpy as np
from measuring import Measure

import ropsim

ROBOT = ropsim.robots.load("puma560")
RNG = np.random.default_rng(1)
JOINTS = RNG.uniform(ROBOT.lower_limits, ROBOT.upper_limits, (10_000, 6))


def test_inverse_batch(benchmark: Any) -> None:
    measure = Measure(benchmark)
    targets = ropsim.kinematics.forward_batch(ROBOT, JOINTS)
    found, time = measure(lambda: ropsim.kinematics.inverse_batch(ROBOT, targets), rounds=20)
    assert found.shape == (10_000, 8, 6)
    measure.figure("us per pose, all branches", 1e6 * time.best / len(JOINTS))


def test_inverse_of_one_pose(benchmark: Any) -> None:
    measure = Measure(benchmark)
    pose = ropsim.kinematics.forward(ROBOT, ROBOT.home)
    found, time = measure(lambda: ropsim.kinematics.inverse(ROBOT, pose), rounds=200)
    assert len(found.solutions) > 0
    measure.figure("us per pose, from Python", 1e6 * time.median)


def test_forward_batch(benchmark: Any) -> None:
    measure = Measure(benchmark)
    _, time = measure(lambda: ropsim.kinematics.forward_batch(ROBOT, JOINTS), rounds=20)
    measure.figure("us per pose", 1e6 * time.best / len(JOINTS))
