"""Damped least squares: exact away from singular poses, bounded past them, near to the path."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import damped_path, forward, inverse_path, jacobian
from ropsim.kinematics.testing import MOST_DAMPING, NEAR, damped_step
from ropsim.spatial import Array, Pose

ARM = robots.load("puma560")
EXACT = 1e-12
ROWS, REACH = 81, 0.1  # poses, and [m] to either side of the middle


def line(q: Array) -> Array:
    """Return poses up through that of q, without turning, shape (ROWS, 4, 4)."""
    matrices = np.repeat(forward(ARM, q).matrix()[np.newaxis], ROWS, axis=0)
    matrices[:, 2, 3] += np.linspace(-REACH, REACH, ROWS)
    return matrices


def past_the_wrist(q5: float) -> tuple[Array, Array]:
    """Return a line on which joint 5 changes its sign, this far from its singular pose, and its start."""
    q = np.array([0.1, 0.9, -2.4, 0.3, q5, 0.2])
    matrices = line(q)
    half = inverse_path(ARM, matrices[: ROWS // 2 + 1][::-1], q)
    return matrices, half[-1]


def test_away_from_singular_poses_it_is_the_exact_answer() -> None:
    q = np.array([0.1, 0.9, -2.4, 0.3, 0.8, 0.2])
    matrices = line(q)
    start = inverse_path(ARM, matrices[: ROWS // 2 + 1][::-1], q)[-1]
    found = damped_path(ARM, matrices, start, Pose())
    np.testing.assert_allclose(found.q, inverse_path(ARM, matrices, start), rtol=0.0, atol=EXACT)
    assert max(found.distance, found.turn) < EXACT


@pytest.mark.parametrize("q5", [2e-4, 1e-3, 2e-3])
def test_past_a_singular_wrist_the_joints_hardly_move_and_the_tool_stays_near(q5: float) -> None:
    """The exact answer turns joint 4 about; the damped one goes through, no further off than its distance."""
    matrices, start = past_the_wrist(q5)
    exact = inverse_path(ARM, matrices, start)
    found = damped_path(ARM, matrices, start, Pose())
    assert np.abs(np.diff(exact, axis=0)).max() > 0.25
    assert np.abs(np.diff(found.q, axis=0)).max() < 0.015
    assert found.turn < q5
    assert found.distance < 0.3 * q5
    np.testing.assert_allclose(forward(ARM, found.q[-1]).matrix(), matrices[-1], rtol=0.0, atol=1e-7)


def test_no_step_of_the_pose_moves_the_joints_further_than_the_damping_allows() -> None:
    """σ/(σ² + λ²) ≤ 1/(2·λ): at a singular pose 25 times the step, which has no bound without damping."""
    q = np.array([0.1, 0.9, -2.4, 0.3, 1e-7, 0.2])
    X, step = forward(ARM, q).matrix(), 1e-4
    lost = np.linalg.svd(jacobian(ARM, q))[0][:, -1]
    there = X.copy()
    there[:3, 3] += step * lost[:3]
    found = damped_path(ARM, np.array([X, there]), q, Pose())
    most = max(0.5 / MOST_DAMPING, 1.0 / NEAR)
    assert np.linalg.norm(found.q[1] - q) < 3.0 * most * step
    assert np.linalg.norm(np.linalg.pinv(jacobian(ARM, q), rcond=1e-15) @ lost) > 1e5


def test_each_direction_near_a_singular_pose_is_damped_by_its_own_distance() -> None:
    """Two of the directions are near one; the others have Newton's step."""
    sigma = np.array([1.0, 0.8, 0.3, 0.06, 0.03, 0.01])
    damping = MOST_DAMPING * (1.0 - (sigma / NEAR) ** 2) * (sigma < NEAR)
    found = damped_step(np.diag(sigma), np.ones(6), 1.0)
    np.testing.assert_allclose(found, sigma / (sigma**2 + damping**2), rtol=EXACT)


def test_no_gain_exceeds_thirty_and_none_jumps_where_damping_begins() -> None:
    """Joints turn by at most 30 times the step of the pose, the number that `MOST_DAMPING` says."""
    sigma = np.linspace(1e-6, 1.2 * NEAR, 2001)
    gains = np.array([damped_step(np.diag((*np.ones(5), one)), np.ones(6), 1.0)[-1] for one in sigma])
    assert 29.0 < gains.max() < 30.0
    assert np.abs(np.diff(gains)).max() < 0.1
