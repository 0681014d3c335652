"""Arms of two to five turning joints of any geometry: all branches of the poses that they can take."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from ropsim.kinematics import (
    IkOptions,
    IkStatus,
    Limits,
    Method,
    chain_arrays,
    forward,
    forward_batch,
    inverse,
    inverse_batch,
    solver_of,
)
from ropsim.kinematics.testing import TASK_SLACK, polished
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose
from support.arms import random_arm
from support.axis_chains import random_chain
from support.published_arms import FIVE_AXES, published_arm, random_joints

STARTS = 200
SAME = 5e-3  # rad: a pose that is off by 1e-5 moves its nearest answer by the square root of that
POSES = 8
IGNORED = IkOptions(Limits.IGNORE)
AXES = ("zyyyx", "zyyyz", "zyyxz", "zyxyx", "xyzyx", "zxyzx", "zzyyx", "zyzyz", "zyyz", "zyyy", "zyxz", "zyx")
ARMS = {
    **{f"random {n} {seed}": random_arm(seed, "R" * n) for n in (5, 4, 3, 2) for seed in range(2)},
    **{axes: random_chain(axes, seed) for seed, axes in enumerate(AXES)},
    **{f"{axes} aligned": random_chain(axes, 5, often=0.5) for axes in ("zyyyz", "zyxyx", "zyyxz", "xyzyx")},
    **{name: published_arm(name) for name in FIVE_AXES},
}
by_arm = pytest.mark.parametrize("robot", ARMS.values(), ids=ARMS.keys())


def apart(q: Array, other: Array) -> Array:
    return np.asarray(np.abs((q - other + pi) % (2.0 * pi) - pi).max(axis=-1))


@by_arm
def test_no_answer_of_a_search_from_many_random_starts_is_missing(robot: RobotModel) -> None:
    assert (solver_of(robot).name, solver_of(robot).method) == ("general few-axis", Method.ALGEBRAIC)
    rng = np.random.default_rng(1)
    Q = random_joints(robot, POSES, seed=2)
    T = forward_batch(robot, Q)
    found = polished(chain_arrays(robot), T, rng.uniform(-pi, pi, (POSES, STARTS, robot.n)), TASK_SLACK)
    for q, X, answers, rows in zip(Q, T, found, inverse_batch(robot, T), strict=True):
        branches = rows[~np.isnan(rows[:, 0])]
        assert apart(branches, q).min() < SAME
        for answer in answers[~np.isnan(answers[:, 0])]:
            assert apart(branches, answer).min() < SAME
        for k, one in enumerate(branches):
            assert (apart(np.delete(branches, k, axis=0), one) > 1e-5).all()
        miss = np.abs(forward_batch(robot, branches) - X).sum(axis=(1, 2))
        assert (miss <= TASK_SLACK).all()


def test_arms_with_parallel_axes_have_several_branches() -> None:
    rows = inverse_batch(
        ARMS["zyyyx"], forward_batch(ARMS["zyyyx"], random_joints(ARMS["zyyyx"], 20, seed=3))
    )
    assert ((~np.isnan(rows[:, :, 0])).sum(axis=1) >= 2).all()


@by_arm
def test_a_pose_off_by_the_rounding_of_files_is_projected(robot: RobotModel) -> None:
    rng = np.random.default_rng(4)
    for q in random_joints(robot, 4, seed=5):
        pose = forward(robot, q)
        off = Pose(rng.normal(size=3) * 3e-7, np.array([1.0, *(rng.normal(size=3) * 2e-7)]))
        found = inverse(robot, pose @ off, IGNORED)
        assert found.status is IkStatus.FOUND
        assert apart(found.solutions, q).min() < SAME


@pytest.mark.parametrize("name", ["random 5 0", "zyyyz", "ufactory_xarm5"])
def test_a_pose_that_few_joints_do_not_take_is_out_of_their_task_space(name: str) -> None:
    robot = ARMS[name]
    pose = forward(robot, random_joints(robot, 1, seed=6)[0])
    turned = pose @ Pose(orientation=np.array([1.0, 0.3, 0.2, -0.4]))
    found = inverse(robot, turned)
    assert found.status is IkStatus.OUT_OF_TASK_SPACE
    assert found.shortfall is not None
    assert found.shortfall.miss is not None
    assert "cannot take every pose" in found.shortfall.miss.why
    far = inverse(robot, replace(pose, position=np.array([9.0, 0.0, 0.0])))
    assert far.status is IkStatus.OUT_OF_REACH


def test_axes_that_coincide_leave_families_to_the_numeric_solver() -> None:
    robot = random_chain("zzyyx", 5, often=0.0)
    assert solver_of(robot).name == "numeric"
