"""The bound of the speed of a point: no posture exceeds it, and a stretched arm attains it."""

from dataclasses import replace
from math import inf, pi

import numpy as np
import pytest

from ropsim.kinematics import jacobian_at, speed_bound
from ropsim.robots import load
from ropsim.spatial import Pose

POINT = np.array([0.03, -0.02, 0.2])


@pytest.mark.parametrize("name", ["puma560", "scara", "stanford", "ur5e", "iiwa14", "two_link"])
def test_no_posture_makes_a_point_faster(name: str) -> None:
    robot = load(name)
    bound = speed_bound(robot, POINT)
    random = np.random.default_rng(5)
    attained = 0.0
    for q in random.uniform(robot.lower_limits, robot.upper_limits, (400, robot.n)):
        J = jacobian_at(robot, q, Pose(POINT))[:3]
        for direction in random.normal(size=(8, 3)):
            unit = direction / np.linalg.norm(direction)
            attained = max(attained, float(np.abs(unit @ J) @ robot.max_speeds))
    assert 0.35 * bound < attained <= bound


def test_a_stretched_arm_of_two_links_attains_it() -> None:
    robot = load("two_link")
    first, second = (joint.max_speed for joint in robot.axis_joints)
    reach = np.linalg.norm(robot.interface.position)
    upper = np.linalg.norm(robot.joints[1].placement.position)
    assert speed_bound(robot, np.zeros(3)) == pytest.approx(first * (upper + reach) + second * reach)


def test_coupled_joints_have_no_bound() -> None:
    assert speed_bound(load("palletizer"), np.zeros(3)) == inf


def test_turned_about_its_own_axis_a_tool_on_it_stands_still() -> None:
    robot = load("puma560")
    fast = replace(robot.joints[5], max_speed=1000.0 * pi)
    faster = replace(robot, joints=(*robot.joints[:5], fast))
    on_axis = np.array([0.0, 0.0, 0.3])
    assert speed_bound(faster, on_axis) == speed_bound(robot, on_axis)
    assert speed_bound(faster, POINT) > 10.0 * speed_bound(robot, POINT)
