"""One branch of an arm with spherical wrist along many poses."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import (
    ROOM_OF_ROWS,
    exact_arm,
    forward,
    inverse_batch,
    inverse_branch,
    inverse_rows,
    solver_of,
)

PUMA = robots.load("puma560")


@pytest.mark.parametrize("count", [1, 7, 8, 9, 33])
def test_one_branch_of_poses_is_that_among_all_of_them(count: int) -> None:
    arm, random = exact_arm(solver_of(PUMA)), np.random.default_rng(5)
    assert arm is not None
    T = np.stack([forward(PUMA, random.uniform(-3.0, 3.0, 6)).matrix() for _ in range(count)])
    wanted = inverse_batch(PUMA, T)
    for row in range(8):
        out = np.full((count + 1, 6), 7.0)
        inverse_branch(arm, np.zeros(ROOM_OF_ROWS), T, row, out[:count])
        assert np.array_equal(out[:count], wanted[:, row], equal_nan=True)
        assert (out[count] == 7.0).all()


def test_a_pose_of_no_numbers_has_no_branches() -> None:
    arm = exact_arm(solver_of(PUMA))
    assert arm is not None
    out = np.zeros((1, 8, 6))
    inverse_rows(arm, np.zeros(ROOM_OF_ROWS), np.full((1, 4, 4), np.nan), out)
    assert np.isnan(out).all()
    assert exact_arm(solver_of(robots.load("ur10e"))) is None
