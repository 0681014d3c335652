"""Planar arms of two links: the elbow up or down, and the many poses that such an arm has not."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import (
    IkOptions,
    IkStatus,
    Limits,
    Method,
    Posture,
    classes_missed,
    forward,
    forward_batch,
    inverse,
    inverse_batch,
    joint_frames,
    posture,
    solver_of,
)
from ropsim.model import DhRow, RobotModel
from ropsim.spatial import Array, Pose
from support.arms import random_arm
from support.wrist_arms import arm

EXACT = 1e-9
"""Rounding of a closed form [rad, m]."""
OWN = 1e-6
"""A stretched arm turns rounding by 1e-16 into its square root [rad]."""
ARM = robots.load("two_link")
CROOKED = arm(
    (DhRow(a=0.5, alpha=pi, d=0.1, theta=0.3), DhRow(a=0.3, alpha=0.4, d=0.2, theta=-1.0)),
    Pose(np.array([0.4, -0.2, 1.0]), np.array([0.8, 0.3, -0.4, 0.1])),
    Pose(np.array([0.01, 0.02, 0.03]), np.array([0.5, 0.1, 0.7, -0.2])),
)
UP, DOWN = Posture(("up",)), Posture(("down",))


def apart(q: Array, other: Array) -> Array:
    return np.asarray(np.abs((q - other + pi) % (2.0 * pi) - pi).max(axis=-1))


@pytest.mark.parametrize("robot", [ARM, CROOKED])
def test_two_links_are_recognised(robot: RobotModel) -> None:
    solver = solver_of(robot)
    assert (solver.name, solver.method) == ("planar two-link", Method.CLOSED_FORM)
    assert set(solver.postures) == {UP, DOWN}


@pytest.mark.parametrize("robot", [ARM, CROOKED])
def test_the_configuration_itself_is_the_answer_in_its_row(robot: RobotModel) -> None:
    Q = np.random.default_rng(1).uniform(-pi, pi, (300, 2))
    Q[:40] = np.round(Q[:40] / (pi / 4)) * (pi / 4)
    T = forward_batch(robot, Q)
    branches = inverse_batch(robot, T)
    present = ~np.isnan(branches[:, :, 0])
    np.testing.assert_allclose(
        forward_batch(robot, branches[present]), np.repeat(T, present.sum(axis=1), axis=0), atol=EXACT
    )
    distances = np.where(present, apart(branches, Q[:, None]), np.inf)
    assert distances.min(axis=1).max() < OWN
    for q, row in zip(Q, distances.argmin(axis=1), strict=True):
        if abs(posture_bend(robot, q)) > OWN:
            assert posture(robot, q) == solver_of(robot).postures[row]


def posture_bend(robot: RobotModel, q: Array) -> float:
    """Return twice the area of elbow, axis 1 and end of link 2 [m²]: 0 where the arm is stretched."""
    frames = joint_frames(robot, q)
    axis, elbow = frames[0, :3, 2], frames[1, :3, 3] - frames[0, :3, 3]
    end = frames[-1, :3, 3] - frames[0, :3, 3]
    return float(np.cross(elbow, end) @ axis)


@pytest.mark.parametrize("robot", [ARM, CROOKED])
def test_up_is_left_of_the_line_to_the_end_and_down_right_of_it(robot: RobotModel) -> None:
    for q in np.random.default_rng(2).uniform(-pi, pi, (50, 2)):
        side = posture_bend(robot, q)  # positive: the end is left of the elbow, the elbow right of the line
        assert posture(robot, q) == (DOWN if side > 0.0 else UP)


def test_an_elbow_that_is_above_the_line_is_up() -> None:
    """Upper arm steep, forearm level: the arm reaches to the right."""
    assert posture(ARM, [1.2, -1.1]) == UP
    assert joint_frames(ARM, [1.2, -1.1])[1, 2, 3] > 0.9


def test_the_orientation_has_to_be_the_one_that_follows_from_the_position() -> None:
    pose = forward(ARM, [0.3, 0.8])
    found = inverse(ARM, pose @ Pose(orientation=np.array([np.cos(0.1), 0.0, 0.0, np.sin(0.1)])))
    assert found.status is IkStatus.OUT_OF_TASK_SPACE
    assert found.shortfall is not None
    assert found.shortfall.miss is not None
    assert found.shortfall.miss.distance == 0.0
    assert found.shortfall.miss.angle == pytest.approx(0.2)


def test_a_pose_beside_the_plane_is_told_by_its_distance_and_tilt() -> None:
    pose = forward(ARM, [0.3, 0.8])
    found = inverse(ARM, replace(pose, position=pose.position + np.array((0.0, 0.04, 0.0))))
    assert found.status is IkStatus.OUT_OF_TASK_SPACE
    assert found.shortfall is not None
    assert found.shortfall.miss is not None
    assert found.shortfall.miss.distance == pytest.approx(0.04)
    assert found.shortfall.miss.angle == pytest.approx(0.0, abs=EXACT)


def test_a_point_out_of_reach_is_told_by_its_distance_from_axis_1() -> None:
    found = inverse(ARM, replace(forward(ARM, [0.3, 0.8]), position=np.array([0.0, 0.0, 2.5])))
    assert found.status is IkStatus.OUT_OF_REACH
    assert found.reach is not None
    assert found.reach.axis == "1"
    assert found.reach.distance == pytest.approx(2.5)
    assert (found.reach.shortest, found.reach.longest) == pytest.approx((0.0, 2.0))


def test_limits_are_looked_at() -> None:
    narrow = replace(ARM, joints=tuple(replace(joint, lower=-0.5, upper=0.5) for joint in ARM.joints))
    pose = forward(narrow, [0.3, 0.8])
    found = inverse(narrow, pose)
    assert found.status is IkStatus.OUT_OF_LIMITS
    assert [one.name for one in found.violations] == ["2"]
    assert inverse(narrow, pose, IkOptions(Limits.IGNORE)).status is IkStatus.FOUND


@pytest.mark.parametrize(
    ("robot", "reason"),
    [
        (random_arm(1, "RR"), "its axes are not parallel"),
        (random_arm(1, "RP"), "joint `2` is prismatic"),
        (random_arm(1, "R"), "it has 1 joint, the class has 2"),
        (arm((DhRow(0.5, 0.0, 0.1), DhRow(0.0, 0.0, 0.1))), "one of its two links has no length"),
    ],
)
def test_other_arms_are_told_by_the_condition_that_they_miss(robot: RobotModel, reason: str) -> None:
    assert solver_of(robot).name != "planar two-link"
    assert classes_missed(robot)["planar two-link"] == reason
