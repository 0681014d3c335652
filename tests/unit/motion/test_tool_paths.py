"""How paths with limits of their own are walked."""

import numpy as np
import pytest

from ropsim.motion import JointPoints, PathMotion, no_path_motion
from ropsim.motion.testing import PathLoad, most_step
from ropsim.spatial import Array

INF = np.inf


def ways(accelerations: list[float], jerks: list[float]) -> PathMotion:
    column = (np.array(each)[:, None] for each in (accelerations, jerks))
    accelerations_, jerks_ = column
    nothing = np.zeros_like(accelerations_)
    return PathMotion(nothing, accelerations_, nothing + INF, jerks_)


def steps_allowed(paths: PathMotion, phi: Array, period: float) -> Array:
    """Return by how much the acceleration of each path may differ from that of the tick before."""
    load = PathLoad(paths.speeds, paths.accelerations, paths.most_accelerations, paths.most_jerks)
    timing = np.stack((phi, np.ones(len(phi)), np.zeros(len(phi))))
    places = np.ndindex(paths.speeds.shape)
    return np.array([most_step(load, timing, k, j, period) for k, j in places]).reshape(paths.speeds.shape)


def test_the_lesser_limit_of_two_ticks_counts() -> None:
    found = steps_allowed(ways([0.0, 0.0, 0.0], [3.0, 2.0, 5.0]), np.array([0.0, 0.1, 0.2]), 0.1)
    assert found[:, 0] == pytest.approx([0.3, 0.2, 0.2])


def test_what_the_plan_does_between_two_ticks_is_allowed() -> None:
    """From 0 to 0.6 in 0.1 s of motion time is a jerk of 6, more than either limit."""
    found = steps_allowed(ways([0.0, 0.6], [3.0, 2.0]), np.array([0.0, 0.1]), 0.05)
    assert found[1, 0] == pytest.approx(0.05 * 6.0)


def test_a_motion_that_stands_still_in_motion_time_has_its_limit() -> None:
    found = steps_allowed(ways([0.0, 0.0], [3.0, 3.0]), np.array([0.4, 0.4]), 0.1)
    assert found[1, 0] == pytest.approx(0.3)


def test_where_a_path_begins_or_ends_there_is_no_limit() -> None:
    found = steps_allowed(ways([0.0, 1.0, 0.0], [INF, 2.0, INF]), np.array([0.0, 0.1, 0.2]), 0.1)
    assert found[1:, 0].tolist() == [INF, INF]


def test_paths_stand_behind_the_joints() -> None:
    points = JointPoints(np.zeros((2, 2)), np.array([[1.0, 2.0], [3.0, 4.0]]), np.ones((2, 2)))
    first, second = ways([5.0, 6.0], [1.0, 1.0]).with_joints(points)
    assert first.tolist() == [[1.0, 2.0, 0.0], [3.0, 4.0, 0.0]]
    assert second.tolist() == [[1.0, 1.0, 5.0], [1.0, 1.0, 6.0]]
    assert no_path_motion(2).with_joints(points)[0].tolist() == points.d1.tolist()
