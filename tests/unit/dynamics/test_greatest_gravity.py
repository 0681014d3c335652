"""The greatest efforts against gravity are those of the worst posture within the limits."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest

from ropsim import robots
from ropsim.dynamics import gravity_loads, greatest_gravity_loads
from ropsim.kinematics import configurations
from ropsim.model import RobotModel

GRID = 2e-3
"""Relative: coordinates are tried every five degrees, cos 2.5° = 0.999, and one after the other."""


def limited(robot: RobotModel, lower: float, upper: float) -> RobotModel:
    joints = [replace(one, lower=lower, upper=upper) for one in robot.joints]
    return replace(robot, joints=tuple(joints), home=np.full(robot.n, 0.5 * (lower + upper)))


@pytest.mark.parametrize("name", ["ur5e", "kr210_r2700_2", "iiwa14", "panda", "m10ia_12", "irb660_180_315"])
def test_no_posture_within_the_limits_needs_more(name: str) -> None:
    robot = robots.load(name)
    sampled = np.abs(gravity_loads(robot, configurations(robot, 4096))).max(axis=0)
    assert (greatest_gravity_loads(robot) >= sampled * (1.0 - GRID) - 1e-9).all()


def test_the_worst_posture_at_the_limits_of_all_axes_is_found() -> None:
    """A two-link arm within 30° to 60° bears most with both links as level as they may be: a corner."""
    robot = limited(robots.load("two_link"), radians(30.0), radians(60.0))
    corners = np.radians([[one, other] for one in (30.0, 60.0) for other in (30.0, 60.0)])
    expected = np.abs(gravity_loads(robot, corners)).max(axis=0)
    np.testing.assert_allclose(greatest_gravity_loads(robot), expected, rtol=1e-12)
    spread = np.abs(gravity_loads(robot, configurations(robot, 128))).max(axis=0)
    assert (spread < expected).all()
