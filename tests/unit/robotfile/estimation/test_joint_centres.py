"""Joints are where the axes are, however their frames are placed."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import SourceText
from ropsim.model import Joint, JointType, RobotModel
from ropsim.robotfile import read_robot_file, write_robot_file
from ropsim.robotfile.testing import joint_centres
from ropsim.spatial import Array, Pose

ROUNDING = 1e-9
"""Of products of frames [m]."""


def centres(robot: RobotModel) -> Array:
    return joint_centres(robot.joints, robot.X_nM).points


def with_shifted_frames(robot: RobotModel) -> RobotModel:
    """Return the same arm with each joint frame shifted along its axis and turned about it."""
    joints: list[Joint] = []
    before = np.eye(4)
    for number, joint in enumerate(robot.joints):
        X = np.eye(4)
        turn = 0.3 * (number + 1)
        X[:2, :2] = [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
        X[2, 3] = 0.1 * (-1) ** number if joint.type is JointType.REVOLUTE else 0.0
        placement = Pose.from_matrix(np.linalg.inv(before) @ joint.placement.matrix() @ X)
        joints.append(replace(joint, placement=placement))
        before = X
    X_nM = Pose.from_matrix(np.linalg.inv(before) @ robot.X_nM.matrix())
    return replace(robot, joints=tuple(joints), X_nM=X_nM, dh=())


@pytest.mark.parametrize("name", ["irb120", "ur10e", "panda", "iiwa14", "tx60", "puma560"])
def test_they_do_not_depend_on_where_frames_stand_on_the_axes(name: str) -> None:
    robot = robots.load(name)
    np.testing.assert_allclose(centres(with_shifted_frames(robot)), centres(robot), atol=ROUNDING)


def test_they_do_not_depend_on_the_form_of_the_table() -> None:
    robot = robots.load("ur5e")  # of a table of the standard form
    text = write_robot_file(replace(robot, dh=())).text
    other = read_robot_file(SourceText("a.toml", text)).robot
    assert other is not None
    assert 'convention = "modified"' in text
    np.testing.assert_allclose(centres(other), centres(robot), atol=ROUNDING)


def test_of_a_wrist_with_one_centre_the_forearm_begins_at_three_tenths_and_the_hand_beyond_the_wrist() -> (
    None
):
    """IRB 140: d1 352, a1 70, a2 360, d4 380, flange 65 mm; at rest the arm is up and the forearm ahead."""
    found = centres(robots.load("irb140"))
    wanted = [
        [0.0, 0.0, 0.176],
        [0.07, 0.0, 0.352],
        [0.07, 0.0, 0.712],
        [0.07 + 0.3 * 0.38, 0.0, 0.712],
        [0.45, 0.0, 0.712],
        [0.45 + 0.6 * 0.065, 0.0, 0.712],
        [0.45 + 0.065, 0.0, 0.712],
    ]
    np.testing.assert_allclose(found, wanted, atol=1e-6)


def test_parallel_axes_are_reached_abreast() -> None:
    """A UR arm: axes 2, 3 and 4 are parallel, their joints lie in the plane of the shoulder."""
    robot = robots.load("ur10e")
    frames = joint_centres(robot.joints, robot.X_nM).frames
    shoulder, elbow, wrist = centres(robot)[1:4]
    axis = frames[1, :3, 2]
    assert abs(axis @ (elbow - shoulder)) < ROUNDING
    assert np.linalg.norm(elbow - shoulder) == pytest.approx(0.6127)
    along = wrist - elbow - axis * float(axis @ (wrist - elbow))
    assert np.linalg.norm(along) == pytest.approx(0.57155)


def test_the_last_joint_lies_on_its_axis_even_where_the_interface_does_not() -> None:
    robot = robots.load("two_link")
    np.testing.assert_allclose(centres(robot), [[0, 0, 0], [1, 0, 0], [2, 0, 0]], atol=ROUNDING)
