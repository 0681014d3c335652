from dataclasses import replace
from math import pi

import numpy as np
import pytest

from ropsim import kinematics, robots
from ropsim.kinematics import NoClosedFormError, has_closed_form
from ropsim.kinematics.wrist import wrist_arm
from ropsim.model import DhRow, JointType, RobotModel
from support.arms import random_arm
from support.wrist_arms import all_arms, arm, backward, industrial

PUMA_ROWS = robots.load("puma560").dh


def with_row(index: int, **changes: float) -> RobotModel:
    rows = list(PUMA_ROWS)
    rows[index] = replace(rows[index], **changes)  # type: ignore[arg-type]  # fields by name
    return arm(tuple(rows))


def test_arms_with_spherical_wrist_are_recognised() -> None:
    assert all(has_closed_form(robot) for robot in all_arms())


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
        (with_row(3, a=1e-6), "axes 4, 5 and 6 do not meet in one point"),
        (with_row(1, a=0.0), "the upper arm or the forearm has no length"),
    ],
)
def test_other_arms_are_refused_with_the_condition_that_they_miss(robot: RobotModel, reason: str) -> None:
    assert not has_closed_form(robot)
    with pytest.raises(NoClosedFormError) as caught:
        kinematics.inverse_batch(robot, np.eye(4)[np.newaxis])
    assert caught.value.diagnostic.code == "M550"
    assert caught.value.diagnostic.data["reason"] == reason


def test_a_prismatic_joint_in_the_table_is_refused() -> None:
    rows = list(PUMA_ROWS)
    rows[2] = DhRow(a=0.0, alpha=pi / 2, d=0.1, type=JointType.PRISMATIC)
    assert not has_closed_form(arm(tuple(rows)))
