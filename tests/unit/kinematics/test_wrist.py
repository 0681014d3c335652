from dataclasses import replace
from math import pi
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import Method, classes_missed, forward_batch, inverse_batch, solver_of
from ropsim.kinematics.testing import SphericalWristSolver, WristArm
from ropsim.model import DhRow, JointType, RobotModel
from support.arms import random_arm
from support.wrist_arms import all_arms, arm, backward, industrial

PUMA_ROWS = robots.load("puma560").dh


def with_row(index: int, **changes: Any) -> RobotModel:
    rows = list(PUMA_ROWS)
    rows[index] = replace(rows[index], **changes)
    return arm(tuple(rows))


def wrist_arm(robot: RobotModel) -> WristArm:
    solver = solver_of(robot)
    assert isinstance(solver, SphericalWristSolver)
    return solver.arm


def test_arms_with_spherical_wrist_are_recognised() -> None:
    assert {solver_of(robot).name for robot in all_arms()} == {"spherical wrist"}
    assert {solver_of(robot).method for robot in all_arms()} == {Method.CLOSED_FORM}


def test_lengths_of_the_puma_are_those_of_its_table() -> None:
    lengths = wrist_arm(robots.load("puma560")).lengths
    forearm = np.hypot(0.0203, 0.4318)
    np.testing.assert_allclose(lengths, [0.0, 0.67183, 0.15005, 0.4318, forearm], atol=1e-15)


def test_axis_2_of_an_industrial_arm_lies_ahead_of_axis_1() -> None:
    arm_ahead, arm_behind = wrist_arm(industrial()), wrist_arm(backward())
    assert arm_ahead.lengths[0] * arm_ahead.front == pytest.approx(0.175)
    assert arm_behind.lengths[0] * arm_behind.front == pytest.approx(0.2)


@pytest.mark.parametrize(
    ("robot", "reason"),
    [
        (robots.load("two_link"), "it has 2 joints, the class has 6"),
        (random_arm(1, "RRRRRP"), "joint `6` is prismatic"),
        (random_arm(1, "RRRRRR"), "axis 2 is not perpendicular to axis 1"),
        (with_row(1, alpha=0.1), "axes 2 and 3 are not parallel"),
        (with_row(3, alpha=1.2), "axis 5 is not perpendicular to axis 4"),
        (with_row(4, alpha=1.2), "axis 6 is not perpendicular to axis 5"),
        (with_row(4, d=0.1), "axes 4, 5 and 6 do not meet in one point"),
        (with_row(3, a=2e-5), "axes 4, 5 and 6 do not meet in one point"),
        (with_row(1, a=0.0), "the upper arm or the forearm has no length"),
    ],
)
def test_other_arms_are_told_by_the_condition_that_they_miss(robot: RobotModel, reason: str) -> None:
    assert solver_of(robot).name != "spherical wrist"
    assert classes_missed(robot)["spherical wrist"] == reason


def test_a_prismatic_joint_in_the_table_is_refused() -> None:
    rows = list(PUMA_ROWS)
    rows[2] = DhRow(a=0.0, alpha=pi / 2, d=0.1, type=JointType.PRISMATIC)
    assert classes_missed(arm(tuple(rows)))["spherical wrist"] == "joint `3` is prismatic"


@pytest.mark.parametrize("beta", [0.0, pi])
@pytest.mark.parametrize("robot", all_arms(), ids=lambda robot: robot.name)
def test_wrists_whose_axes_are_aligned_either_way_are_solved(robot: RobotModel, beta: float) -> None:
    """Axes 4 and 6 turn the tool alike then, or against each other: only what they do together is told."""
    arm_found = wrist_arm(robot)
    q = np.random.default_rng(3).uniform(-1.0, 1.0, (20, 6))
    q[:, 4] = arm_found.signs[4] * (beta - arm_found.zeros[4])
    T = forward_batch(robot, q)
    found = inverse_batch(robot, T)
    same = np.abs(found[:, :, :3] - q[:, None, :3]).max(axis=2) < 1e-6
    assert same.any(axis=1).all()
    again = forward_batch(robot, found[same])
    np.testing.assert_allclose(again, np.repeat(T, same.sum(axis=1), axis=0), atol=1e-9)


@pytest.mark.parametrize("robot", all_arms(), ids=lambda robot: robot.name)
def test_angles_of_half_a_turn_are_told_in_one_way_only(robot: RobotModel) -> None:
    """All coordinates lie in (-π, π]; so does what rounding leaves at its ends."""
    random = np.random.default_rng(4)
    q = random.choice([-pi, pi, np.nextafter(-pi, 0.0), 0.7, -1.1], (60, 6))
    found = inverse_batch(robot, forward_batch(robot, q))
    there = ~np.isnan(found)
    assert there.any()
    assert (found[there] > -pi).all()
    assert (found[there] <= pi).all()
