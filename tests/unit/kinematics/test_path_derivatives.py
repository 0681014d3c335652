"""Derivatives of the joints along a path of the tool, against motions of the joints that are known."""

from collections.abc import Callable

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import (
    followed,
    forward_batch,
    has_path_derivatives,
    is_followed,
    jacobians_at,
    path_derivatives,
)
from ropsim.model import RobotModel, on_track
from ropsim.spatial import Array, Pose

X_MT = Pose(np.array([0.1, 0.05, 0.2]), np.array([0.9, 0.1, -0.3, 0.2]))
STEP = 1e-5
BENT = {
    "panda": (0.1, -0.8, 0.1, -2.3, 0.1, 1.6, 0.8),
    "iiwa14": (0.1, 0.6, 0.2, -1.3, 0.1, 0.9, 0.2),
}
"""Configurations away from singularities [rad]."""
DIFFERENCES = 1e-7  # of the tool's second derivatives, which are central differences
ARMS = ("irb120", "ur5e", "puma560", "stanford", "scara", "palletizer", "two_link", "m410ib_700")


def motion_of(robot: RobotModel, seed: int) -> tuple[Array, Array, Array]:
    """Return coordinates of a random configuration, and first and second derivatives of a motion there."""
    random = np.random.default_rng(seed)
    low, high = (np.clip(limit, -2.5, 2.5) for limit in (robot.lower_limits, robot.upper_limits))
    rates = random.normal(size=(2, robot.n))
    rates[:, list(robot.external)] = 0.0
    return low + random.uniform(0.2, 0.8, robot.n) * (high - low), rates[0], rates[1]


def tool_of(robot: RobotModel, q: Array, first: Array, second: Array) -> Array:
    """Return the derivatives of the tool for q(s) = q + s·q' + s²/2·q'' at s = 0, shape (2, 1, 6)."""

    def velocity(s: float) -> Array:
        J = jacobians_at(robot, (q + s * first + 0.5 * s * s * second)[np.newaxis], X_MT)[1]
        return np.asarray(J[0] @ (first + s * second))

    return np.stack((velocity(0.0), (velocity(STEP) - velocity(-STEP)) / (2.0 * STEP)))[:, np.newaxis]


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("name", ARMS)
def test_the_derivatives_of_a_known_motion_come_back_from_those_of_its_tool(name: str, seed: int) -> None:
    robot = robots.load(name)
    q, first, second = motion_of(robot, seed)
    found = path_derivatives(robot, q[np.newaxis], X_MT, tool_of(robot, q, first, second))
    assert found is not None
    np.testing.assert_allclose(found[:, 0], (first, second), atol=DIFFERENCES)


def test_external_axes_stand_still() -> None:
    robot = on_track(robots.load("puma560"), robots.linear_track(4.0))
    q, first, second = motion_of(robot, 1)
    found = path_derivatives(robot, q[np.newaxis], X_MT, tool_of(robot, q, first, second))
    assert found is not None
    np.testing.assert_allclose(found[:, 0], (first, second), atol=DIFFERENCES)
    assert not found[:, 0, list(robot.external)].any()


def test_next_to_a_singularity_there_are_none() -> None:
    robot = robots.load("puma560")
    q, first, second = motion_of(robot, 1)
    q[4] = 1e-7
    assert path_derivatives(robot, q[np.newaxis], X_MT, tool_of(robot, q, first, second)) is None


def test_a_tool_that_an_arm_of_few_joints_cannot_follow_gives_none() -> None:
    robot = robots.load("scara")
    q, first, second = motion_of(robot, 1)
    tool = tool_of(robot, q, first, second)
    tool[0, 0, 3] += 1e-3
    assert path_derivatives(robot, q[np.newaxis], X_MT, tool) is None


@pytest.mark.parametrize("name", ["panda", "iiwa14"])
def test_a_redundant_arm_takes_the_least_rates(name: str) -> None:
    robot = robots.load(name)
    assert is_followed(robot)
    assert has_path_derivatives(robot)
    q, first, second = motion_of(robot, 2)
    found = path_derivatives(robot, q[np.newaxis], X_MT, tool := tool_of(robot, q, first, second))
    assert found is not None
    J = jacobians_at(robot, q[np.newaxis], X_MT)[1][0]
    np.testing.assert_allclose(found[0, 0], np.linalg.pinv(J) @ tool[0, 0], atol=1e-12)


def waved(robot: RobotModel, q: Array, s: Array) -> tuple[Array, Array]:
    """Return poses X_BM along a line with a wave, (k, 4, 4), and derivatives of the tool, (2, k, 6)."""
    X = forward_batch(robot, q[np.newaxis])[0]
    ahead, aside = np.array([-0.6, 0.0, -0.8]), np.array([0.0, 1.0, 0.0])
    T, tool = np.tile(X, (len(s), 1, 1)), np.zeros((2, len(s), 6))
    T[:, :3, 3] += 0.1 * s[:, None] * ahead + 0.05 * np.sin(3.0 * s)[:, None] * aside
    tool[0, :, :3] = 0.1 * ahead + 0.15 * np.cos(3.0 * s)[:, None] * aside
    tool[1, :, :3] = -0.45 * np.sin(3.0 * s)[:, None] * aside
    return T, tool


@pytest.fixture(params=["panda", "iiwa14"])
def follow(request: pytest.FixtureRequest) -> Callable[[Array], tuple[Array, Array]]:
    """Return the joints of a redundant arm, and their derivatives, at path parameters of a path."""
    robot = robots.load(request.param)
    q = np.array(BENT[request.param])

    def rows(s: Array) -> tuple[Array, Array]:
        found = followed(robot, s, *(waved(robot, q, s)[:1]), q, X_MT, waved(robot, q, s)[1])
        assert found is not None
        np.testing.assert_allclose(forward_batch(robot, found[0]), waved(robot, q, s)[0], atol=1e-9)
        return found

    return rows


def test_derivatives_of_a_followed_path_are_those_of_its_joints(
    follow: Callable[[Array], tuple[Array, Array]],
) -> None:
    s = np.linspace(0.0, 1.0, 401)
    q, (d1, d2) = follow(s)
    step = s[1]
    first = (q[:-4] - 8.0 * q[1:-3] + 8.0 * q[3:-1] - q[4:]) / (12.0 * step)
    second = (d1[:-4] - 8.0 * d1[1:-3] + 8.0 * d1[3:-1] - d1[4:]) / (12.0 * step)
    np.testing.assert_allclose(d1[2:-2], first, atol=1e-6)
    np.testing.assert_allclose(d2[2:-2], second, atol=1e-5)


def test_where_the_rows_lie_does_not_count_for_the_joints(
    follow: Callable[[Array], tuple[Array, Array]],
) -> None:
    """Of third order: half the distance leaves about an eighth of the error."""
    coarse, fine, finest = (follow(np.linspace(0.0, 1.0, count))[0][-1] for count in (21, 41, 321))
    errors = [np.abs(one - finest).max() for one in (coarse, fine)]
    assert errors[0] < 1e-4
    assert errors[1] < errors[0] / 5.0
