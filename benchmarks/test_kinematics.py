"""Forward and inverse kinematics of the PUMA 560."""

import numpy as np
from pytest_benchmark.fixture import BenchmarkFixture

import ropsim

ROBOT = ropsim.robots.load("puma560")
RNG = np.random.default_rng(1)
JOINTS = RNG.uniform(ROBOT.lower_limits, ROBOT.upper_limits, (10_000, 6))


def test_inverse_batch(benchmark: BenchmarkFixture) -> None:
    targets = ropsim.kinematics.forward_batch(ROBOT, JOINTS)
    found = benchmark(ropsim.kinematics.inverse_batch, ROBOT, targets)
    assert found.shape == (10_000, 8, 6)
    benchmark.extra_info["us_per_pose_all_branches"] = 1e6 * benchmark.stats.stats.median / len(JOINTS)


def test_inverse_of_one_pose(benchmark: BenchmarkFixture) -> None:
    pose = ropsim.kinematics.forward(ROBOT, ROBOT.home)
    found = benchmark(ropsim.kinematics.inverse, ROBOT, pose)
    assert len(found.solutions) > 0


def test_forward_batch(benchmark: BenchmarkFixture) -> None:
    benchmark(ropsim.kinematics.forward_batch, ROBOT, JOINTS)
    benchmark.extra_info["us_per_pose"] = 1e6 * benchmark.stats.stats.median / len(JOINTS)
