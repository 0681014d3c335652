from dataclasses import replace
from math import pi

import numpy as np
import pytest

from ropsim import robots
from ropsim.model import joint_tree, placement_matrices, pose_matrices
from ropsim.spatial import Pose


@pytest.mark.parametrize("name", robots.names())
def test_rotations_of_built_in_robots_are_exact(name: str) -> None:
    rotations, _ = placement_matrices(joint_tree(robots.load(name)))
    assert set(np.unique(rotations)) <= {-1.0, 0.0, 1.0}
    assert not np.signbit(rotations[rotations == 0.0]).any()


def test_positions_are_those_of_the_drawing() -> None:
    _, positions = placement_matrices(joint_tree(robots.load("puma560")))
    np.testing.assert_array_equal(positions[1:4], [[0, 0, 0.67183], [0.4318, 0, 0], [0.0203, 0, 0.15005]])


def test_small_angles_of_a_calibrated_arm_are_kept() -> None:
    robot = robots.load("two_link")
    tilt = 1e-12
    tilted = Pose(np.zeros(3), np.array([1.0, tilt / 2.0, 0.0, 0.0]))
    robot = replace(robot, joints=(robot.joints[0], replace(robot.joints[1], placement=tilted)))
    assert placement_matrices(joint_tree(robot))[0][1, 2, 1] == pytest.approx(tilt, rel=1e-9)


def test_interface_of_a_right_angle_is_exact() -> None:
    turned = Pose(np.array([0.0, 0.0, 0.1]), np.array([np.cos(pi / 4), 0.0, 0.0, np.sin(pi / 4)]))
    R_nM, p_nM = pose_matrices(turned)
    np.testing.assert_array_equal(R_nM, [[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    np.testing.assert_array_equal(p_nM, [0.0, 0.0, 0.1])
