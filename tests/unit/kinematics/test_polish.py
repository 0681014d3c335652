"""Polishing: nearby joint coordinates become those of the pose, and others are left out."""

import numpy as np
import pytest

from ropsim.kinematics import forward_batch
from ropsim.kinematics.arrays import chain_arrays
from ropsim.kinematics.chain_kernel import refine_rows
from ropsim.kinematics.polish import POSE_SLACK, checked, continued, nearest_to, polished, refine
from ropsim.spatial import Array
from support.arms import random_arm

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
    from ropsim.kinematics import polish_kernel

    compiled = polished(CHAIN, T[:3], (Q[:3] + 1e-3)[:, None])
    rows = polish_kernel.polish_rows
    monkeypatch.setattr(polish_kernel, "polish_rows", getattr(rows, "__wrapped__", rows))
    plain = polished(CHAIN, T[:3], (Q[:3] + 1e-3)[:, None])
    np.testing.assert_allclose(plain, compiled, rtol=0.0, atol=ROUNDING)


TURNING = random_arm(24, "RRRRRR")


def refined(poses: Array, starts: Array) -> tuple[Array, object]:
    found = np.array(starts)
    return found, refine(chain_arrays(TURNING), poses, found)


def test_refining_ends_where_polishing_does() -> None:
    poses = forward_batch(TURNING, Q)
    starts = Q[:, None] + np.array([1e-9, 1e-6, 1e-3])[:, None] * np.cos(np.arange(6))
    starts = np.concatenate((starts, np.full((30, 1, 6), np.nan), Q[:, None] + 0.1), axis=1)
    found, lost = refined(poses, starts)
    np.testing.assert_array_equal(np.isnan(found[:, 3]), True)
    np.testing.assert_allclose(found[:, :3], np.tile(Q[:, None], (1, 3, 1)), rtol=0.0, atol=1e4 * ROUNDING)
    expected = polished(chain_arrays(TURNING), poses, starts[:, 4:])
    np.testing.assert_allclose(found[:, 4:], expected, rtol=0.0, atol=1e4 * ROUNDING)
    assert (lost is not None) == bool(np.isnan(found[:, 4]).any())


@pytest.mark.parametrize(
    "shape", [np.diag([1.01] * 3), np.diag([-1.0] * 3), np.eye(3) + 0.01 * np.eye(3)[::-1]]
)
def test_refining_loses_matrices_that_are_no_poses(shape: Array) -> None:
    poses = forward_batch(TURNING, Q[:4])
    poses[2:, :3, :3] = shape @ poses[2:, :3, :3]
    found, lost = refined(poses, Q[:4, None])
    assert np.isnan(found[:, 0, 0]).tolist() == [False, False, True, True]
    np.testing.assert_array_equal(lost, [[False], [False], [True], [True]])


def test_refining_does_the_same_without_numba() -> None:
    plain = getattr(refine_rows, "__wrapped__", refine_rows)
    chain, poses = chain_arrays(TURNING), forward_batch(TURNING, Q[:2])
    starts = Q[:2, None] + np.array([1e-7, 1e-5])[:, None] * np.sin(np.arange(6))
    found, answers = np.array(starts), np.array(starts)
    plain(chain.flat, poses, found, np.empty((3, 2)), np.empty((7, 12)), np.empty((7, 7)))
    assert refine(chain, poses, answers) is None
    np.testing.assert_allclose(found, answers, rtol=0.0, atol=ROUNDING)
