"""Chains without a closed form: any number of joints, turning and sliding."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from ropsim.kinematics import (
    IkOptions,
    IkStatus,
    Limits,
    Method,
    classes_missed,
    forward,
    forward_batch,
    inverse,
    inverse_batch,
    inverse_path,
    posture,
    solver_of,
)
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose
from support.arms import random_arm
from support.redundant_poses import awkward_joints, narrowed

POSE_TOLERANCE = 1e-9
"""What the inverse kinematics promises [m, entries of the rotation matrix]."""
OWN = 1e-6
"""Near singularities rounding of 1e-16 moves coordinates by its square root [rad | m]."""
BY_ANOTHER = 1e-6
"""To which scipy's least squares ends at the same place [rad | m]."""
CHAINS = ["R", "P", "RP", "PR", "PPP", "RRR", "RPR", "RRRR", "RRPRR", "RRRRRR", "RRPRRR", "PRRRRR", "RRRRRRR"]


def middle(count: int, n: int, seed: int) -> Array:
    return np.random.default_rng(seed).uniform(-1.5, 1.5, (count, n))


def test_the_solver_says_that_it_is_numeric_and_why() -> None:
    robot = random_arm(3, "RRPRRRR")
    solver = solver_of(robot)
    assert (solver.name, solver.method, solver.parts) == ("numeric", Method.NUMERIC, ())
    assert classes_missed(robot) == {
        "spherical wrist": "it has 7 joints, the class has 6",
        "three parallel axes": "it has 7 joints, the class has 6",
        "sliding joint, spherical wrist": "it has 7 joints, the class has 6",
        "SCARA": "it has 7 joints, the class has 4",
        "planar two-link": "it has 7 joints, the class has 2",
        "level wrist": "it has 7 joints, the class has 4",
        "S-R-S": "joint `3` is prismatic",
        "general few-axis": "it has 7 joints, the class has 2 to 5",
        "general six-axis": "it has 7 joints, the class has 6",
        "general seven-axis": "joint `3` is prismatic",
    }


@pytest.mark.parametrize("types", CHAINS)
def test_answers_reach_the_pose_and_one_is_near_to_where_the_arm_stands(types: str) -> None:
    robot = random_arm(5, types)
    for q in middle(8, robot.n, seed=1):
        pose = forward(robot, q)
        found = inverse(robot, pose, IkOptions(Limits.IGNORE, near=q + 0.01))
        assert found.status is IkStatus.FOUND
        reached = forward_batch(robot, found.solutions)
        expected = np.tile(pose.matrix(), (len(reached), 1, 1))
        np.testing.assert_allclose(reached, expected, rtol=0.0, atol=POSE_TOLERANCE)
        off = np.abs(found.solutions[0] - q).max()
        assert off < (OWN if robot.n <= 6 else 0.05)
        assert set(found.postures) == {posture(robot, q)}


@pytest.mark.parametrize("types", ["RRR", "RPR", "RRRRP", "RRPRRR"])
def test_the_configuration_itself_is_found_without_a_hint(types: str) -> None:
    robot = random_arm(7, types)
    Q = middle(20, robot.n, seed=2)
    branches = inverse_batch(robot, forward_batch(robot, Q))
    own = np.abs(branches - Q[:, None]).max(axis=2)
    found = (np.nan_to_num(own, nan=np.inf) < OWN).any(axis=1)
    assert found.sum() >= len(Q) - 1  # no promise of all branches


@pytest.mark.parametrize("seed", range(4))
def test_the_answer_of_another_solver_from_the_same_start_is_among_them(seed: int) -> None:
    """Levenberg–Marquardt of MINPACK from the same start, on the twelve numbers of the pose."""
    robot = random_arm(seed, "RRPRRR")
    (q,) = middle(1, 6, seed=seed)
    pose, start = forward(robot, q), q + 0.05

    def miss(value: Array) -> Array:
        return np.asarray((forward(robot, value).matrix() - pose.matrix())[:3].ravel())

    expected = least_squares(miss, start, method="lm", xtol=1e-14, ftol=1e-14, gtol=1e-14).x
    found = inverse(robot, pose, IkOptions(Limits.IGNORE, near=start)).solutions
    assert np.abs(found - expected).max(axis=1).min() < BY_ANOTHER


def test_the_same_question_has_the_same_answers() -> None:
    robot = random_arm(9, "RRPRRR")
    pose = forward(robot, middle(1, 6, seed=3)[0])
    first, again = inverse(robot, pose).branches, inverse(robot, pose).branches
    np.testing.assert_array_equal(first, again)
    np.testing.assert_array_equal(inverse_batch(robot, pose.matrix()[None])[0], first)


@pytest.mark.parametrize("types", ["RP", "RPR", "RRPRR"])
def test_an_arm_with_few_joints_refuses_poses_that_it_has_not(types: str) -> None:
    robot = random_arm(11, types)
    pose = forward(robot, middle(1, robot.n, seed=4)[0])
    beside = pose @ Pose(orientation=np.array([1.0, 0.3, 0.2, -0.4]))
    found = inverse(robot, replace(beside, position=beside.position + np.array((0.2, 0.1, 0.3))))
    assert found.status is IkStatus.NOT_FOUND
    assert len(found.solutions) == 0
    assert found.shortfall is not None
    assert found.shortfall.miss is not None
    assert "cannot take every pose" in found.shortfall.miss.why
    assert found.shortfall.miss.distance + found.shortfall.miss.angle > 0.01


def test_a_pose_too_far_away_is_told_by_what_is_missing() -> None:
    robot = random_arm(3, "RRRRRRR")
    pose = forward(robot, middle(1, 7, seed=5)[0])
    found = inverse(robot, replace(pose, position=np.array([20.0, 0.0, 0.0])))
    assert found.status is IkStatus.OUT_OF_REACH
    assert found.shortfall is not None
    assert found.shortfall.miss is not None
    assert 10.0 < found.shortfall.miss.distance < 20.0


def test_limits_are_looked_at() -> None:
    robot = random_arm(3, "PPP")
    pose = forward(robot, [0.5, 0.2, 3.5])
    found = inverse(robot, pose)
    assert found.status is IkStatus.OUT_OF_LIMITS
    assert [(one.name, one.limit) for one in found.violations] == [("3", 3.0)]
    assert found.violations[0].value == pytest.approx(3.5)


@pytest.mark.parametrize("types", ["RRRRRR", "RRRRRRR", "RPR"])
def test_a_path_is_followed_from_pose_to_pose_without_whole_turns(types: str) -> None:
    robot = random_arm(13, types)
    start = middle(1, robot.n, seed=6)[0]
    start[0] += 2.0 * np.pi
    Q = start + np.linspace(0.01, 0.5, 50)[:, None] * np.cos(np.arange(robot.n))
    T = forward_batch(robot, Q)
    path = inverse_path(robot, T, start)
    np.testing.assert_allclose(forward_batch(robot, path), T, rtol=0.0, atol=POSE_TOLERANCE)
    assert np.abs(np.diff(path, axis=0, prepend=start[None])).max() < 0.05
    if robot.n <= 6:
        np.testing.assert_allclose(path, Q, rtol=0.0, atol=OWN)


def test_a_path_ends_where_a_pose_is_not_reached() -> None:
    robot = random_arm(13, "RRRRRR")
    (q,) = middle(1, 6, seed=7)
    T = np.tile(forward(robot, q).matrix(), (5, 1, 1))
    T[3, :3, 3] += 20.0
    path = inverse_path(robot, T, q)
    np.testing.assert_allclose(path[:3], np.tile(q, (3, 1)), atol=OWN)
    assert np.isnan(path[3:]).all()


@pytest.mark.parametrize("broken", ["scaled", "mirrored", "nan"])
def test_matrices_that_are_no_poses_have_no_answers(broken: str) -> None:
    robot = random_arm(3, "RRPRRR")
    T = forward(robot, middle(1, 6, seed=8)[0]).matrix()
    T[:3, :3] *= {"scaled": 1.01, "mirrored": -1.0, "nan": np.nan}[broken]
    assert np.isnan(inverse_batch(robot, T[None])).all()


def with_limits(types: str, seed: int) -> RobotModel:
    return narrowed(random_arm(seed, types), seed)


@pytest.mark.parametrize("types", ["RRRRRRRR", "RRRRRRRRR", "PRRRRRR", "RRPRRRR", "PPRRRRRR"])
def test_arms_with_more_joints_than_a_pose_needs_find_it_within_narrow_limits(types: str) -> None:
    for seed in range(2):
        robot = with_limits(types, seed)
        for q in awkward_joints(robot, 12, seed=seed):
            found = inverse(robot, forward(robot, q))
            assert found.status is IkStatus.FOUND
            rows = found.solutions
            assert ((rows >= robot.lower_limits) & (rows <= robot.upper_limits)).all()
            expected = [forward(robot, q).matrix()] * len(rows)
            np.testing.assert_allclose(forward_batch(robot, rows), expected, rtol=0.0, atol=POSE_TOLERANCE)


@pytest.mark.slow
@pytest.mark.parametrize("types", ["RRRRRRRR", "RRRRRRRRR", "PRRRRRR", "RRPRRRR", "PPRRRRRR"])
def test_no_pose_of_many_is_lost_by_arms_with_more_joints(types: str) -> None:
    for seed in range(4):
        robot = with_limits(types, seed)
        lost = [
            q
            for q in awkward_joints(robot, 100, seed=seed)
            if inverse(robot, forward(robot, q)).status is not IkStatus.FOUND
        ]
        assert lost == []


def test_what_a_search_does_not_find_is_out_of_reach_only_beyond_all_links_in_a_line() -> None:
    robot = random_arm(3, "RRPRRR")
    pose = forward(robot, np.zeros(6))
    near, far = (replace(pose, position=np.array(at)) for at in ((0.5, -2.5, -2.0), (20.0, 0.0, 0.0)))
    assert inverse(robot, near).status is IkStatus.NOT_FOUND
    assert inverse(robot, far).status is IkStatus.OUT_OF_REACH
