"""Limits of tool paths that joints allow: cited figures, and laws."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.model import PathDefaults, RobotModel
from ropsim.robots import path_limits_of_joints

CITED = {
    "gp25": (10.0, 8.6, 20.0),
    "iiwa14": (4.4, 1.9, 13.0),
    "irb120": (4.6, 5.3, 23.0),
    "irb140": (5.3, 6.3, 27.0),
    "irb4600_60_205": (5.9, 5.3, 21.0),
    "kr210_r2700_2": (2.2, 3.5, 2.2),
    "kr6_r900_2": (5.6, 8.1, 25.0),
    "manutec_r3": (10.0, 3.5, 43.0),
    "panda": (4.0, 2.6, 14.0),
    "ur5e": (5.7, 2.8, 20.0),
}
"""Acceleration [m/s²], speed [rad/s] and acceleration [rad/s²] of orientation, of other samples."""
CLOSE = 0.1


def limits(robot: RobotModel) -> PathDefaults:
    found = path_limits_of_joints(robot)
    assert found is not None
    return found


@pytest.mark.parametrize("name", CITED)
def test_cited_figures_come_out(name: str) -> None:
    found = limits(robots.load(name))
    rates = found.acceleration, found.orientation_speed, found.orientation_acceleration
    assert rates == pytest.approx(CITED[name], rel=CLOSE)


def test_full_acceleration_takes_a_tenth_of_a_second() -> None:
    found = limits(robots.load("irb120"))
    assert found.jerk == pytest.approx(found.acceleration / 0.1)
    assert found.orientation_jerk == pytest.approx(found.orientation_acceleration / 0.1)


def test_twice_the_acceleration_of_the_joints_is_twice_that_of_the_tool() -> None:
    robot = robots.load("irb120")
    joints = tuple(replace(one, max_acceleration=2.0 * one.max_acceleration) for one in robot.joints)
    once, twice = limits(robot), limits(replace(robot, joints=joints))
    assert twice.acceleration == pytest.approx(2.0 * once.acceleration, rel=0.05)  # of two digits
    assert twice.orientation_acceleration == pytest.approx(2.0 * once.orientation_acceleration, rel=0.05)
    assert twice.orientation_speed == once.orientation_speed


@pytest.mark.parametrize("name", robots.names())
def test_every_arm_of_the_library_has_such_limits(name: str) -> None:
    found = limits(robots.load(name))
    assert 0.2 < found.acceleration < 30.0
    assert 0.0 < found.orientation_speed <= 8.7


def test_a_lone_axis_has_none_of_orientation_beyond_its_own() -> None:
    robot = robots.load("two_link")
    found = limits(robot)
    assert found.orientation_speed <= np.sum(robot.max_speeds)


def test_what_is_no_arm_has_none() -> None:
    assert path_limits_of_joints(robots.conveyor(1.0, 0.5, 0.8)) is None
