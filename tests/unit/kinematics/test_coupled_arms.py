"""Six-axis arms whose makers count axis 3 together with axis 2: every branch, in their coordinates."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import (
    IkOptions,
    Limits,
    Method,
    classes_missed,
    forward,
    forward_batch,
    frames_batch,
    inverse,
    inverse_batch,
    jacobian,
    posture,
    singular_distances,
    solver_of,
)
from ropsim.kinematics.testing import plain_arm
from ropsim.model import Coupling, RobotModel, coupled_limits
from ropsim.spatial import Array

ARMS = {"irb2400_16": -1.0, "lr_mate_200id": 1.0, "m10ia_12": 1.0}
"""Joint 3 itself is at axis 3 and so many times axis 2."""
EXACT = 1e-9
"""Promised of answers [rad; m, entries of the rotation matrix]."""
REGULAR = 1e-3
"""Nearer to a singular posture the coordinates of a pose are less sure than the pose [m, rad]."""


def within(robot: RobotModel, count: int) -> Array:
    """Return configurations within the limits of axes and joints, shape (count, n)."""
    rng = np.random.default_rng(5)
    Q = rng.uniform(robot.lower_limits, robot.upper_limits, (3 * count, robot.n))
    kept: Array = Q[(coupled_limits(robot).excess(Q) == 0.0).all(axis=1)][:count]
    assert len(kept) == count
    return kept


@pytest.mark.parametrize(
    ("name", "count"), [("irb2400_16", 500), ("lr_mate_200id", 500), ("m10ia_12", 10_000)]
)
def test_every_branch_of_ten_thousand_poses_reaches_it_and_the_one_that_made_it_is_among_them(
    name: str, count: int
) -> None:
    robot = robots.load(name)
    Q = within(robot, count)
    poses = forward_batch(robot, Q)
    found = inverse_batch(robot, poses)
    present = ~np.isnan(found[..., 0])
    again = forward_batch(robot, found[present])
    assert np.abs(again - np.repeat(poses, present.sum(axis=1), axis=0)).max() < EXACT
    apart = found - Q[:, np.newaxis]
    apart -= 2.0 * np.pi * np.round(apart / (2.0 * np.pi))
    off = np.where(present, np.abs(apart).max(axis=2), np.inf).min(axis=1)
    assert (off < EXACT).mean() > 0.9999
    for q in Q[off >= EXACT]:
        left = singular_distances(robot, q)
        assert left is not None
        assert min(left.shoulder, left.elbow, left.wrist) < REGULAR


@pytest.mark.parametrize("name", ARMS)
def test_solutions_are_within_the_limits_of_axes_and_of_the_joint_in_every_turn(name: str) -> None:
    robot, both = robots.load(name), coupled_limits(robots.load(name))
    for q in within(robot, 60):
        found = inverse(robot, forward(robot, q))
        rows = np.vstack([*found.solutions, *found.turns])
        assert np.abs(rows - q).max(axis=1).min() < 1e-7
        assert (both.excess(rows) == 0.0).all()
        assert (rows >= robot.lower_limits).all()
        assert (rows <= robot.upper_limits).all()
        free = inverse(robot, forward(robot, q), IkOptions(Limits.IGNORE))
        assert posture(robot, q) in found.postures
        assert set(found.postures) <= set(free.postures)


@pytest.mark.parametrize("name", ARMS)
def test_axis_2_alone_leaves_the_forearm_as_it_was_turned(name: str) -> None:
    robot = robots.load(name)
    q = np.array([0.3, 0.2, -0.4, 0.5, 0.6, 0.7])
    moved = q + np.array([0.0, 0.5, 0.0, 0.0, 0.0, 0.0])
    one, other = frames_batch(robot, np.array([q, moved]))[:, 2, :3, :3]
    np.testing.assert_allclose(one, other, atol=1e-14)
    np.testing.assert_allclose(jacobian(robot, q)[3:, 1], 0.0, atol=1e-14)


def test_the_joint_itself_has_limits_beside_those_of_the_axis() -> None:
    for name, factor in ARMS.items():
        both = coupled_limits(robots.load(name))
        second, third = (robots.load(name).axis_joints[k].name for k in (1, 2))
        assert both.joints[0].name == f"{third} {'+' if factor > 0.0 else '-'} {second}"
        np.testing.assert_array_equal(both.T[0], [0.0, factor, 1.0, 0.0, 0.0, 0.0])


def test_crank_lower_arm_forearm_and_rod_of_the_irb_2400_close() -> None:
    robot = robots.load("irb2400_16")
    frames = frames_batch(robot, within(robot, 20))
    elbow, crank, rod = (frames[:, number] for number in (2, 6, 7))
    pin = robot.joints[7].placement.position
    foot = rod[:, :3, 3]
    np.testing.assert_allclose(foot, (crank @ np.append(pin, 1.0))[:, :3], atol=1e-12)
    lower_arm = np.linalg.norm(robot.joints[2].placement.position)
    along = frames[:, 2, :3, 3] - frames[:, 1, :3, 3]
    np.testing.assert_allclose(foot + along, (elbow @ np.append(pin, 1.0))[:, :3], atol=1e-12)
    at_zero = frames_batch(robot, np.zeros((1, 6)))[0]
    head = at_zero[7, :3, :3].T @ (at_zero[2, :3, 3] - at_zero[1, :3, 3])
    np.testing.assert_allclose(np.linalg.norm(head), lower_arm, atol=1e-12)
    np.testing.assert_allclose(rod[:, :3, :3] @ head, along, atol=1e-12)


def test_the_class_is_that_of_the_joints_and_told_so() -> None:
    robot = robots.load("m10ia_12")
    plain = plain_arm(robot)
    assert plain is not None
    assert [joint.name for joint in plain.joints] == ["J1", "J2", "J3 + J2", "J4", "J5", "J6"]
    assert "spherical wrist" not in classes_missed(robot)
    assert (solver_of(robot).name, solver_of(robot).method) == ("spherical wrist", Method.CLOSED_FORM)


def test_a_singular_pose_keeps_the_axes_where_they_are() -> None:
    robot = robots.load("lr_mate_200id")
    q = np.array([0.2, 0.3, 0.4, 0.5, 0.0, -0.3])
    found = inverse(robot, forward(robot, q), IkOptions(near=q))
    assert np.abs(found.solutions - q).max(axis=1).min() < EXACT
    left = singular_distances(robot, q)
    assert left is not None
    assert left.wrist < EXACT


@pytest.mark.parametrize("factor", [0.5, 0.25])
def test_axes_whose_turns_are_no_turns_of_the_joints_are_left_to_the_numeric_solver(factor: float) -> None:
    robot = robots.load("m10ia_12")
    (one,) = robot.couplings
    terms = (one.terms[0], (one.terms[1][0], factor))
    other = replace(robot, couplings=(Coupling(one.dependent, terms),))
    assert plain_arm(other) is None
    assert solver_of(other).method is Method.NUMERIC
    assert "couplings" in classes_missed(other)["spherical wrist"]
