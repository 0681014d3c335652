"""Polishing: nearby joint coordinates become those of the pose, and others are left out."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.codegen import Compiled
from ropsim.kinematics import chain_arrays, forward_batch, solver_of
from ropsim.kinematics.testing import (
    POSE_SLACK,
    ROOM,
    SphericalWristSolver,
    ThreeParallelSolver,
    checked,
    continued,
    held_at,
    nearest_to,
    polished,
    polished_within,
    refine,
    refine_rows,
    shape_of,
    spherical_wrist,
    three_parallel,
)
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose
from support.arms import random_arm
from support.in_python import in_python
from support.published_arms import published_arm

ROUNDING = 1e-12
"""Of coordinates of arms far from singularities [rad | m]."""
ROBOT = random_arm(21, "RRPRRR")
CHAIN = chain_arrays(ROBOT)
Q = np.random.default_rng(1).uniform(-1.0, 1.0, (30, 6))
T = forward_batch(ROBOT, Q)


def test_coordinates_a_little_off_become_those_of_the_pose() -> None:
    found = polished(CHAIN, T, (Q + 1e-3)[:, None])[:, 0]
    np.testing.assert_allclose(found, Q, rtol=0.0, atol=1e5 * ROUNDING)


def test_rows_that_reach_their_pose_pass_the_check_unchanged() -> None:
    np.testing.assert_array_equal(checked(CHAIN, T, Q[:, None])[:, 0], Q)


@pytest.mark.parametrize(("off", "passes"), [(0.01, True), (100.0, False)])
def test_the_check_is_as_fine_as_promised(off: float, passes: bool) -> None:
    moved = Q + off * POSE_SLACK
    assert (~np.isnan(checked(CHAIN, T, moved[:, None])[:, 0, 0]) == passes).all()


def test_rows_without_a_start_stay_without_an_answer() -> None:
    starts = np.tile(Q[:, None], (1, 2, 1))
    starts[:, 1] = np.nan
    found = polished(CHAIN, T, starts)
    assert np.isnan(found[:, 1]).all()
    assert not np.isnan(found[:, 0]).any()


def test_angles_are_within_half_a_turn_and_slides_are_not_turned() -> None:
    turned = Q + 2.0 * np.pi * np.array([1, -1, 0, 2, 0, -1])
    np.testing.assert_allclose(polished(CHAIN, T, turned[:, None])[:, 0], Q, rtol=0.0, atol=1e4 * ROUNDING)
    slid = random_arm(22, "PPP")
    far = np.array([[8.0, -9.0, 7.0]])
    found = polished(chain_arrays(slid), forward_batch(slid, far), (far + 0.1)[:, None])[:, 0]
    np.testing.assert_allclose(found, far, rtol=0.0, atol=1e4 * ROUNDING)


def test_a_path_keeps_its_turns() -> None:
    start = Q[0] + 2.0 * np.pi * np.array([1, 0, 0, 0, -1, 0])
    path = start + np.linspace(0.0, 0.2, 20)[:, None]
    found = continued(CHAIN, forward_batch(ROBOT, path), start)
    np.testing.assert_allclose(found, path, rtol=0.0, atol=1e4 * ROUNDING)


def test_a_search_that_fails_ends_nearer_than_it_began() -> None:
    robot = random_arm(23, "RRRRRR")  # without a slide, which would take it there
    poses = forward_batch(robot, Q[:5])
    away = poses.copy()
    away[:, 0, 3] += 30.0
    ends = nearest_to(chain_arrays(robot), away, Q[:5, None])[:, 0]
    after = np.linalg.norm(forward_batch(robot, ends)[:, :3, 3] - away[:, :3, 3], axis=1)
    assert (after < 30.0).all()
    assert np.isnan(polished(chain_arrays(robot), away, Q[:5, None])).all()


def test_the_kernel_does_the_same_without_numba(monkeypatch: pytest.MonkeyPatch) -> None:
    from ropsim.kinematics.testing import polish_kernel

    compiled = polished(CHAIN, T[:3], (Q[:3] + 1e-3)[:, None])
    rows = polish_kernel.polish_rows
    monkeypatch.setattr(polish_kernel, "polish_rows", in_python(rows))
    plain = polished(CHAIN, T[:3], (Q[:3] + 1e-3)[:, None])
    np.testing.assert_allclose(plain, compiled, rtol=0.0, atol=ROUNDING)


def fourth_digit(robot: RobotModel) -> RobotModel:
    """Return an arm whose axis 5 is turned as by a file that writes right angles with four digits."""
    off = robot.joints[4].placement @ Pose(orientation=np.array([1.0, 5e-5, 0.0, 0.0]))
    return replace(
        robot, joints=(*robot.joints[:4], replace(robot.joints[4], placement=off), *robot.joints[5:])
    )


ROUNDED = {name: published_arm(name) for name in ("kr6_r900_2", "ur5e_robot")}
ROUNDED["four digits"] = fourth_digit(ROUNDED["kr6_r900_2"])
"""Arms that are off their class by 0.2 nrad, 5 nrad and 0.1 mrad."""
BENT = np.random.default_rng(2).uniform(0.4, 1.0, (30, 6))
"""Configurations away from singular ones [rad]."""
by_rounded_arm = pytest.mark.parametrize("robot", ROUNDED.values(), ids=ROUNDED.keys())


def kernel_of(robot: RobotModel) -> Compiled:
    solver = solver_of(robot)
    if isinstance(solver, SphericalWristSolver):
        return spherical_wrist.refinement(solver)
    assert isinstance(solver, ThreeParallelSolver)
    return three_parallel.refinement(solver)


def refined(robot: RobotModel, poses: Array, starts: Array) -> tuple[Array, object]:
    found = np.array(starts)
    return found, refine(kernel_of(robot), chain_arrays(robot), poses, found)


@by_rounded_arm
def test_refining_ends_where_polishing_does(robot: RobotModel) -> None:
    poses = forward_batch(robot, BENT)
    off = np.array([1e-9, 1e-6, 1e-5, 1e-4, 1e-3, np.nan, 0.1, 0.0])
    starts = BENT[:, None] + off[:, None] * np.cos(np.arange(6))
    found, lost = refined(robot, poses, starts)
    own = [0, 1, 2, 3, 4, 7]
    np.testing.assert_array_equal(np.isnan(found[:, 5]), True)
    np.testing.assert_allclose(found[:, own], np.tile(BENT[:, None], (1, 6, 1)), rtol=0.0, atol=ROUNDING)
    expected = polished(chain_arrays(robot), poses, starts[:, 6:7])
    np.testing.assert_allclose(found[:, 6:7], expected, rtol=0.0, atol=ROUNDING)
    assert lost is None


def test_only_starts_far_away_are_left_to_the_search() -> None:
    robot = ROUNDED["ur5e_robot"]
    room = np.empty(ROOM + 1 + 8)
    starts = BENT[:1, None] + np.array([0.0, 1e-8, 1e-6, 1e-5, 1e-3, np.nan, 0.1, 1.0])[:, None] * np.ones(6)
    kernel_of(robot)(forward_batch(robot, BENT[:1]), starts, room)
    assert room[ROOM:].tolist() == [3.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0]


@pytest.mark.parametrize(
    "shape", [np.diag([1.01] * 3), np.diag([-1.0] * 3), np.eye(3) + 0.01 * np.eye(3)[::-1]]
)
def test_refining_loses_matrices_that_are_no_poses(shape: Array) -> None:
    robot = ROUNDED["kr6_r900_2"]
    poses = forward_batch(robot, BENT[:4])
    poses[2:, :3, :3] = shape @ poses[2:, :3, :3]
    found, lost = refined(robot, poses, np.tile(BENT[:4, None], (1, 8, 1)))
    assert np.isnan(found[:, :, 0]).all(axis=1).tolist() == [False, False, True, True]
    np.testing.assert_array_equal(lost, [[False] * 8, [False] * 8, [True] * 8, [True] * 8])


@by_rounded_arm
def test_refining_does_the_same_without_numba(robot: RobotModel) -> None:
    plain = in_python(refine_rows)
    poses = forward_batch(robot, BENT[:2])
    off = np.array([0.0, 1e-9, 1e-7, 1e-6, 1e-5, 3e-5, np.nan, 1e-4])
    starts = BENT[:2, None] + off[:, None] * np.sin(np.arange(6))
    found, answers = np.array(starts), np.array(starts)
    solver = solver_of(robot)
    assert isinstance(solver, SphericalWristSolver | ThreeParallelSolver)
    parallel = 2 if isinstance(solver, SphericalWristSolver) else 3
    shape = shape_of(solver.arm.X_M[:, 3].tolist(), parallel, solver.snapped_by.size)
    plain(chain_arrays(robot).flat, shape, poses, found, np.empty(ROOM + 1 + 16))
    assert refine(kernel_of(robot), chain_arrays(robot), poses, answers) is None
    np.testing.assert_allclose(found, answers, rtol=0.0, atol=ROUNDING)


def test_answers_within_bounds_are_within_them_and_reach_their_poses() -> None:
    lower, upper = Q.min(axis=0) - 0.2, Q.max(axis=0) + 0.2
    starts = np.stack((lower, upper, 0.5 * (lower + upper)))
    found = polished_within(CHAIN, T, np.tile(starts, (len(Q), 1, 1)), np.array([lower, upper]))
    assert (~np.isnan(found[:, :, 0])).any(axis=1).mean() > 0.5
    rows, place = np.nonzero(~np.isnan(found[:, :, 0]))
    answers = found[rows, place]
    assert ((answers >= lower) & (answers <= upper)).all()
    np.testing.assert_allclose(forward_batch(ROBOT, answers), T[rows], rtol=0.0, atol=1e-9)


def test_a_joint_that_is_held_keeps_its_value() -> None:
    for q, X in zip(Q[:10], T[:10], strict=True):
        found = held_at(CHAIN, X, q[np.newaxis] + 1e-3, 2, float(q[2]))
        np.testing.assert_allclose(found, q[np.newaxis], rtol=0.0, atol=1e4 * ROUNDING)
        assert len(held_at(CHAIN, X, q[np.newaxis], 2, float(q[2]) + 1e-3)) == 0
