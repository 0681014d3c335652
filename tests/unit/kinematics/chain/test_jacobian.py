import numpy as np

from ropsim import kinematics, robots
from ropsim.spatial import Pose
from support.arms import random_arm

ROUNDING = 1e-14
"""A few rounding errors of numbers of the order of 1."""


def test_columns_of_the_two_link_arm_are_levers_across_the_axis() -> None:
    J = kinematics.jacobian(robots.load("two_link"), [0.0, 0.0])
    expected = np.array([[0, 0, 2, 0, -1, 0], [0, 0, 1, 0, -1, 0]]).T
    np.testing.assert_allclose(J, expected, atol=ROUNDING)


def test_a_prismatic_joint_moves_along_its_axis_without_turning() -> None:
    robot = random_arm(4, "RPR")
    q = np.array([0.3, 0.2, -0.1])
    J = kinematics.jacobian(robot, q)
    np.testing.assert_allclose(J[:3, 1], kinematics.joint_frames(robot, q)[1, :3, 2], atol=ROUNDING)
    np.testing.assert_array_equal(J[3:, 1], np.zeros(3))


def test_a_longer_tool_changes_the_linear_rows_only() -> None:
    robot = robots.load("puma560")
    q = robot.home
    bare = kinematics.jacobian(robot, q)
    tool = kinematics.jacobian_at(robot, q, Pose(np.array([0.0, 0.0, 0.2])))
    np.testing.assert_array_equal(tool[3:], bare[3:])
    lever = kinematics.forward(robot, q).rotation() @ [0.0, 0.0, 0.2]
    np.testing.assert_allclose(tool[:3] - bare[:3], np.cross(bare[3:].T, lever).T, atol=ROUNDING)


def test_a_coordinate_of_a_prismatic_joint_is_a_distance() -> None:
    robot = random_arm(4, "P")
    here, there = (kinematics.forward(robot, [d]).position for d in (0.1, 0.4))
    np.testing.assert_allclose(np.linalg.norm(there - here), 0.3, atol=ROUNDING)


def test_the_frame_beside_a_jacobian_is_that_of_forward_kinematics() -> None:
    X_MT = Pose(np.array([0.03, -0.02, 0.2]), np.array([0.9, 0.1, -0.3, 0.2]))
    for name in ("puma560", "scara", "palletizer"):
        robot = robots.load(name)
        q = robot.home + np.linspace(0.1, -0.2, robot.n)
        X_BT, J = kinematics.frame_and_jacobian(robot, q, X_MT)
        assert np.allclose(X_BT, (kinematics.forward(robot, q) @ X_MT).matrix(), atol=1e-12)
        assert np.allclose(J, kinematics.jacobian_at(robot, q, X_MT), atol=1e-12)
