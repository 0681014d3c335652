"""Choice of postures: whole turns, limits and the rows of a start, beside formulas on whole arrays."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import IkOptions, Limits, branches_near, forward, inverse
from ropsim.planning.testing import LIMIT_SLACK, JointRange, nearest_turns
from ropsim.spatial import Array, Pose

TURN = 2.0 * np.pi
SIX = 6
ARMS = ["puma560", "scara", "ur10e", "panda"]


def turned_by_arrays(branches: Array, q_near: Array, limits: JointRange) -> Array:
    """Return the turned branches, each step for all coordinates."""
    fewest = np.ceil((limits.lower - LIMIT_SLACK - branches) / TURN)
    most = np.floor((limits.upper + LIMIT_SLACK - branches) / TURN)
    below = limits.lower - (branches + TURN * most)
    above = branches + TURN * fewest - limits.upper
    wanted = np.clip(np.round((q_near - branches) / TURN), fewest, np.maximum(fewest, most))
    turns = np.where(fewest <= most, wanted, np.where(below <= above, most, fewest))
    return np.asarray(branches + np.where(limits.revolute > 0.0, TURN * turns, 0.0))


@pytest.mark.parametrize("name", ARMS)
def test_turns_and_limits_of_rows_are_those_of_whole_arrays(name: str) -> None:
    random, limits = np.random.default_rng(2), JointRange.of(robots.load(name))
    n = len(limits.lower)
    no_limits = replace(limits, lower=np.full(n, -np.inf), upper=np.full(n, np.inf))
    narrow = replace(limits, lower=np.full(n, 0.3), upper=np.full(n, 0.4))
    for each in (limits, no_limits, narrow):
        for _ in range(50):
            branches, q_near = random.uniform(-7.0, 7.0, (8, n)), random.uniform(-9.0, 9.0, n)
            branches[random.uniform(size=8) < 0.2] = np.nan
            found = nearest_turns(branches, q_near, each)
            assert np.array_equal(found, turned_by_arrays(branches, q_near, each), equal_nan=True)
            assert each.inside(found).tolist() == (each.excess(found) == 0.0).all(axis=1).tolist()


def test_a_coordinate_on_its_limit_is_inside_but_for_more_than_rounding() -> None:
    limits = JointRange.of(robots.load("puma560"))
    rows = [limits.upper + step for step in (0.0, 0.9 * LIMIT_SLACK, 1.1e-9)]
    assert limits.inside(np.array(rows)).tolist() == [True, True, False]


@pytest.mark.parametrize("name", ARMS)
def test_branches_near_a_start_are_those_of_the_whole_answer(name: str) -> None:
    robot, random = robots.load(name), np.random.default_rng(6)
    options = IkOptions() if robot.n > SIX else IkOptions(Limits.IGNORE)  # an elbow keeps to the limits
    low, high = np.maximum(robot.lower_limits, -1.0), np.minimum(robot.upper_limits, 1.0)
    for _ in range(20):
        q = random.uniform(low, high)
        near = q + random.normal(scale=0.01, size=robot.n)
        pose = forward(robot, q)
        found = branches_near(robot, pose, near)
        assert found is not None
        wanted = inverse(robot, pose, replace(options, near=near)).branches
        assert np.array_equal(found, wanted, equal_nan=True)
    far = Pose(np.array([30.0, 0.0, 0.0]))
    assert branches_near(robot, far, robot.home) is None
    assert inverse(robot, far, replace(options, near=robot.home)).shortfall is not None
