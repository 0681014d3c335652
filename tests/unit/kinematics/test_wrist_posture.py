"""The posture of an arm with spherical wrist in compiled code is that of its solver."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import NEAR_SINGULAR, exact_arm, solver_of, wrist_posture, write_pose_product
from ropsim.spatial import Pose

SIDES = (0.0, 1e-6, -1e-6)


@pytest.mark.parametrize("name", ["puma560", "irb4600_60_205", "kr210_r2700_2"])
def test_it_is_that_of_the_solver(name: str) -> None:
    robot = robots.load(name)
    solver, random, told = solver_of(robot), np.random.default_rng(6), np.empty(2)
    arm = exact_arm(solver)
    assert arm is not None
    for _ in range(300):
        q = random.uniform(-3.0, 3.0, 6)
        q[4] = random.choice([q[4], 0.0, 0.01])
        for side in SIDES:
            wrist_posture(arm, q, side, told)
            assert solver.postures[int(told[0])] == solver.posture(q + side)
            assert (told[1] < NEAR_SINGULAR) == solver.may_stay(q + side)


def test_a_product_of_poses_is_that_of_poses_to_the_bit() -> None:
    random, product = np.random.default_rng(7), np.empty(7)
    for _ in range(200):
        one, other = (Pose(random.normal(size=3), random.normal(size=4)) for _ in range(2))
        write_pose_product(np.array(one.as_tuple()), np.array(other.as_tuple()), product)
        assert tuple(product.tolist()) == (one @ other).as_tuple()
