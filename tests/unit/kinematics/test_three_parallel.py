"""Arms with three parallel axes: eight branches, their names, singular poses, and what other arms miss."""

from dataclasses import replace
from math import pi, sin
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import (
    IkOptions,
    IkStatus,
    Limits,
    Method,
    classes_missed,
    forward_batch,
    inverse,
    inverse_batch,
    jacobian,
    posture,
    solver_of,
)
from ropsim.kinematics.testing import ThreeParallelSolver, numeric
from ropsim.model import DhRow, RobotModel
from ropsim.spatial import Array, Pose
from support.published_arms import published_arm
from support.wrist_arms import arm

REACHED = 1e-9  # m, entries of the rotation matrix: what is promised
SAME = 1e-9  # rad
TWICE_SINGULAR = 0.02  # rad: a pose to 1e-9 leaves an elbow and a wrist next to singular so much
NEAR_SINGULAR = 1e-5  # rad: rounding by 1e-16 moves a stretched elbow by its square root

# Universal Robots, DH parameters for calculations of kinematics and dynamics, UR5e.
UR5E = (
    DhRow(a=0.0, alpha=pi / 2, d=0.1625),
    DhRow(a=-0.425, alpha=0.0, d=0.0),
    DhRow(a=-0.3922, alpha=0.0, d=0.0),
    DhRow(a=0.0, alpha=pi / 2, d=0.1333),
    DhRow(a=0.0, alpha=-pi / 2, d=0.0997),
    DhRow(a=0.0, alpha=0.0, d=0.0996),
)
# As different as the class allows: axes the other way round, offsets, axis 2 ahead of axis 1.
OTHER = (
    DhRow(a=0.1, alpha=-pi / 2, d=0.4, theta=0.3),
    DhRow(a=0.5, alpha=pi, d=0.07, theta=0.4),
    DhRow(a=0.3, alpha=pi, d=0.05, theta=-0.7),
    DhRow(a=0.06, alpha=-pi / 2, d=0.02, theta=1.1),
    DhRow(a=0.0, alpha=pi / 2, d=0.12, theta=0.2),
    DhRow(a=0.0, alpha=0.0, d=0.1, theta=-0.5),
)
TILTED = Pose(np.array([0.4, -0.2, 1.0]), np.array([0.8, 0.3, -0.4, 0.1]))
FLANGE = Pose(np.array([0.01, 0.02, 0.03]), np.array([0.5, 0.1, 0.7, -0.2]))
ARMS = {"ur5e": arm(UR5E), "other": arm(OTHER, TILTED, FLANGE)}
PLANE = arm((UR5E[0], *UR5E[1:3], replace(UR5E[3], d=0.0), *UR5E[4:]))
"""The UR5e without its lateral offset: P can be on axis 1."""

by_arm = pytest.mark.parametrize("robot", ARMS.values(), ids=ARMS.keys())


def apart(q: Array, other: Array) -> Array:
    return np.asarray(np.abs((q - other + pi) % (2.0 * pi) - pi).max(axis=-1))


def joints(count: int, seed: int) -> Array:
    return np.random.default_rng(seed).uniform(-pi, pi, (count, 6))


def solver(robot: RobotModel) -> ThreeParallelSolver:
    found = solver_of(robot)
    assert isinstance(found, ThreeParallelSolver)
    return found


@by_arm
def test_every_answer_reaches_and_one_is_the_configuration_itself(robot: RobotModel) -> None:
    assert solver(robot).method is Method.CLOSED_FORM
    Q = joints(2000, 1)
    T = forward_batch(robot, Q)
    branches = inverse_batch(robot, T)
    present = ~np.isnan(branches[:, :, 0])
    reached = forward_batch(robot, branches[present])
    np.testing.assert_allclose(reached, np.repeat(T, present.sum(axis=1), axis=0), rtol=0.0, atol=REACHED)
    assert np.where(present, apart(branches, Q[:, None]), np.inf).min(axis=1).max() < SAME


@by_arm
def test_rows_have_the_names_of_their_postures(robot: RobotModel) -> None:
    names = solver(robot).postures
    assert len(set(names)) == len(names) == 8
    for rows in inverse_batch(robot, forward_batch(robot, joints(100, 2))):
        assert all(posture(robot, q) == name for q, name in zip(rows, names, strict=True) if q[0] == q[0])


@by_arm
def test_a_search_from_many_starts_finds_no_other_answer(robot: RobotModel) -> None:
    T = forward_batch(robot, joints(10, 3))
    searched, branches = numeric(robot).branches(T, np.zeros(6)), inverse_batch(robot, T)
    for found, known in zip(searched, branches, strict=True):
        for q in found[~np.isnan(found[:, 0])]:
            assert np.nanmin(apart(known, q)) < NEAR_SINGULAR


@by_arm
def test_the_determinant_of_the_jacobian_is_that_of_the_three_singularities(robot: RobotModel) -> None:
    arm_ = solver(robot).arm
    for q in joints(50, 4):
        ahead, elbow, wrist = arm_.turned(q)
        product = arm_.lengths[3] * arm_.lengths[4] * sin(elbow) * sin(wrist) * ahead
        assert abs(np.linalg.det(jacobian(robot, q))) == pytest.approx(abs(product), abs=1e-12)


def aligned(robot: RobotModel, Q: Array) -> Array:
    """Return Q with axis 6 parallel to axis 2, forwards and backwards."""
    arm_ = solver(robot).arm
    Q = Q.copy()
    Q[:, 4] = arm_.signs[4] * (np.arange(len(Q)) % 2 * pi - arm_.zeros[4])
    return Q


@by_arm
def test_with_axis_6_along_axis_2_the_arm_may_stay_where_it_is(robot: RobotModel) -> None:
    for q, T in zip(Q := aligned(robot, joints(40, 5)), forward_batch(robot, Q), strict=True):
        found = inverse(robot, Pose.from_matrix(T), IkOptions(Limits.IGNORE, near=q))
        assert apart(found.solutions, q).min() < NEAR_SINGULAR


@by_arm
def test_with_axis_6_along_axis_2_joint_6_goes_where_the_arm_reaches(robot: RobotModel) -> None:
    """What stays free is chosen as the caller has it, or as near to that as the two links allow."""
    Q = aligned(robot, joints(400, 6))
    T = forward_batch(robot, Q)
    branches = inverse_batch(robot, T)
    present = ~np.isnan(branches[:, :, 0])
    assert present.any(axis=1).all()
    reached = forward_batch(robot, branches[present])
    np.testing.assert_allclose(reached, np.repeat(T, present.sum(axis=1), axis=0), rtol=0.0, atol=REACHED)
    assert 0 < (np.nanmin(np.abs(branches[:, :, 5]), axis=1) < SAME).sum() < len(Q)


@by_arm
@pytest.mark.parametrize("bend", [0.0, pi, 1e-9])
def test_stretched_and_folded_arms_are_solved(robot: RobotModel, bend: float) -> None:
    arm_, Q = solver(robot).arm, joints(200, 7)
    Q[:, 2] = arm_.signs[2] * (bend - arm_.zeros[2])
    branches = inverse_batch(robot, forward_batch(robot, Q))
    assert np.nanmin(apart(branches, Q[:, None]), axis=1).max() < NEAR_SINGULAR


@pytest.mark.parametrize("bend", [0.0, 1e-9, pi])
def test_stretched_and_folded_arms_of_rounded_files_are_solved(bend: float) -> None:
    """With a wrist that is nearly straight, too, a rounding by 1e-9 takes the elbow far beyond stretched."""
    robot = published_arm("ur5e_robot")
    arm_, Q = solver(robot).arm, joints(200, 8)
    Q[:, 2] = arm_.signs[2] * (bend - arm_.zeros[2])
    Q[:, 4] = arm_.signs[4] * (0.02 - arm_.zeros[4])
    branches = inverse_batch(robot, forward_batch(robot, Q))
    present = ~np.isnan(branches[:, :, 0])
    assert present.any(axis=1).all()
    own = np.where(present, apart(branches, Q[:, None]), np.inf).min(axis=1)
    assert (own < TWICE_SINGULAR).all()


def test_joint_1_stays_where_the_point_lies_on_its_axis() -> None:
    arm_, q = solver(PLANE).arm, np.array([0.7, 0.0, 1.9, 0.4, 1.0, 0.3])
    level, upright = (arm_.turned(q + turn * np.eye(6)[1])[0] for turn in (0.0, pi / 2))
    q[1] = np.arctan2(-level, upright)  # joint 2 swings P about axis 2, which meets axis 1
    assert abs(arm_.turned(q)[0]) < SAME
    T = Pose.from_matrix(forward_batch(PLANE, q[None])[0])
    found = inverse(PLANE, T, IkOptions(Limits.IGNORE, near=q))
    assert apart(found.solutions, q).min() < NEAR_SINGULAR


def test_what_is_out_of_reach_is_told_by_its_distance() -> None:
    robot = ARMS["ur5e"]
    far = inverse(robot, Pose(np.array([1.5, 0.0, 0.2])))
    assert far.status is IkStatus.OUT_OF_REACH
    assert far.reach is not None
    assert (far.reach.point, far.reach.axis) == ("axis 4", "2")
    assert far.reach.longest == pytest.approx(0.425 + 0.3922)
    assert far.reach.distance > far.reach.longest
    inside = inverse(robot, Pose(np.array([0.05, 0.0, 0.6]))).reach
    assert inside is not None
    assert inside.axis == "1"
    assert inside.shortest == pytest.approx(0.1333)
    assert inside.distance < inside.shortest


def with_row(index: int, **changes: Any) -> RobotModel:
    rows = list(UR5E)
    rows[index] = replace(rows[index], **changes)
    return arm(tuple(rows))


@pytest.mark.parametrize(
    ("robot", "reason"),
    [
        (robots.load("two_link"), "it has 2 joints, the class has 6"),
        (robots.load("puma560"), "axes 2, 3 and 4 are not parallel"),
        (with_row(0, alpha=1.4), "axis 2 is not perpendicular to axis 1"),
        (with_row(3, alpha=1.4), "axis 5 is not perpendicular to axis 4"),
        (with_row(4, alpha=1.4), "axis 6 is not perpendicular to axis 5"),
        (with_row(4, a=2e-5), "axes 5 and 6 do not meet"),
        (with_row(1, a=0.0), "the upper arm or the forearm has no length"),
    ],
)
def test_other_arms_are_told_by_the_condition_that_they_miss(robot: RobotModel, reason: str) -> None:
    assert classes_missed(robot)["three parallel axes"] == reason
