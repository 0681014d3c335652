"""The Manutec r3 with its published load against the static torques of the Modelica Standard Library."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.dynamics import gravity
from ropsim.model import ElasticGear, Gear, Payload

START = np.radians([-60.0, 20.0, 90.0, 0.0, -110.0, 0.0])
"""Where the path of RobotR3 begins."""
LOAD = Payload(15.0, np.array([0.1, 0.1, 0.25]), 1e-3 * np.eye(3))
"""Its load: 0.1, 0.25, 0.1 m along x, y, z there, of which y points up."""
PUBLISHED = (0.0, -460.573448, -256.400068, 14.0580365, -14.96025, 0.0)
"""Of the gears, at rest [N·m]."""


def test_static_torques_are_those_of_the_published_simulation() -> None:
    robot = robots.load("manutec_r3")
    np.testing.assert_allclose(gravity(robot, START, LOAD), PUBLISHED, rtol=0.0, atol=1e-6)
    assert robot.rated_payload == LOAD.mass


def test_friction_of_the_wrist_is_the_published_one_at_the_joints() -> None:
    drives = robots.load("manutec_r3").drives[3:]
    at_joint = [one.friction.coulomb_positive * abs(one.ratio_at(0.0)) for one in drives]
    assert at_joint == pytest.approx([21.8, 30.1, 10.9])
    assert [one.friction.viscous * one.ratio_at(0.0) ** 2 for one in drives] == pytest.approx(
        [9.8, 0.03, 3.92]
    )


def test_gears_of_axes_1_to_3_are_the_published_springs() -> None:
    gears = [drive.transmission for drive in robots.load("manutec_r3").drives]
    springs = [
        (one.stiffness / one.ratio**2, one.damping / one.ratio**2)
        for one in gears[:3]
        if isinstance(one, ElasticGear)
    ]
    np.testing.assert_allclose(springs, [(43.0, 0.005), (8.0, 0.01), (58.0, 0.04)], rtol=1e-12)
    assert [type(one) for one in gears[3:]] == [Gear] * 3
