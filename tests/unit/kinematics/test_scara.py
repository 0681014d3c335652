"""SCARA arms: two branches in closed form, and what such an arm cannot do."""

from dataclasses import replace
from math import atan2, cos, hypot, pi, sin

import numpy as np
import pytest

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
from ropsim.model import DhRow, JointType, RobotModel
from ropsim.spatial import Array, Pose
from support.arms import random_arm
from support.scara import HEIGHT, L1, L2, TRAVEL, column, rounded, scara
from support.wrist_arms import arm

EXACT = 1e-9
"""Rounding of a closed form, stretched arms left out [rad, m]."""
OWN = 1e-6
"""A stretched arm turns rounding by 1e-16 into its square root [rad]."""
ROUNDED_TILT = 3.0 * (3.1416 - pi)
"""An arm whose own axes are tilted cannot do better [rad, m]."""
COBRA = scara()
ARMS = {"cobra": COBRA, "column": column(), "rounded": rounded()}
RIGHT, LEFT = Posture(("right",)), Posture(("left",))


def apart(robot: RobotModel, q: Array, other: Array) -> Array:
    turning = np.array([joint.type is JointType.REVOLUTE for joint in robot.joints])
    return np.asarray(np.abs(np.where(turning, (q - other + pi) % (2.0 * pi) - pi, q - other)).max(axis=-1))


def configurations(robot: RobotModel, count: int) -> Array:
    lower, upper = np.maximum(robot.lower_limits, -pi), np.minimum(robot.upper_limits, pi)
    return np.random.default_rng(1).uniform(lower, upper, (count, 4))


@pytest.mark.parametrize("name", ARMS)
def test_scara_arms_are_recognised_with_the_slide_in_any_place(name: str) -> None:
    solver = solver_of(ARMS[name])
    assert (solver.name, solver.method) == ("SCARA", Method.CLOSED_FORM)
    assert solver.postures == (RIGHT, LEFT)
    assert (solver.snapped_by.angle > 0.0) == (name == "rounded")


@pytest.mark.parametrize("name", ARMS)
def test_both_branches_reach_the_pose_and_one_is_the_configuration_itself(name: str) -> None:
    robot = ARMS[name]
    Q = configurations(robot, 300)
    Q[:40] = np.round(Q[:40] / (pi / 4)) * (pi / 4)
    T = forward_batch(robot, Q)
    branches = inverse_batch(robot, T)
    assert not np.isnan(branches).any()
    slack = EXACT if name != "rounded" else ROUNDED_TILT
    for row in range(2):
        np.testing.assert_allclose(forward_batch(robot, branches[:, row]), T, rtol=0.0, atol=slack)
    assert apart(robot, branches, Q[:, None]).min(axis=1).max() < OWN


@pytest.mark.parametrize("name", ARMS)
def test_postures_name_the_rows(name: str) -> None:
    robot = ARMS[name]
    for rows in inverse_batch(robot, forward_batch(robot, configurations(robot, 50))):
        assert [posture(robot, q) for q in rows] == [RIGHT, LEFT]


def test_the_answers_are_those_of_two_links_in_a_plane() -> None:
    """The end of link 2 at a point of the plane: law of cosines; a right arm has its elbow on the right."""
    x, y = 0.4, 0.1
    bend = np.arccos((x * x + y * y - L1 * L1 - L2 * L2) / (2.0 * L1 * L2))
    pose = Pose(np.array([x, y, HEIGHT - 0.05]), np.array([0.0, 1.0, 0.0, 0.0]))  # pointing down
    found = inverse(COBRA, pose)
    assert found.status is IkStatus.FOUND
    assert found.postures == (RIGHT, LEFT)
    for q, side in zip(found.solutions, (1.0, -1.0), strict=True):
        first = atan2(y, x) - atan2(L2 * sin(side * bend), L1 + L2 * cos(bend))
        np.testing.assert_allclose(q[:3], [first, side * bend, 0.05], atol=EXACT)
    elbow = L1 * np.array([cos(found.solutions[0][0]), sin(found.solutions[0][0])])
    assert elbow[0] * y - elbow[1] * x > 0.0  # right of the line from axis 1 to (x, y)


def test_a_slide_beyond_its_limit_is_told_in_metres() -> None:
    pose = forward(COBRA, [0.3, 0.8, TRAVEL + 0.04, 0.2])
    found = inverse(COBRA, pose)
    assert found.status is IkStatus.OUT_OF_LIMITS
    (violation,) = found.violations
    assert violation.name == "3"
    assert violation.value == pytest.approx(TRAVEL + 0.04)
    assert violation.limit == TRAVEL
    assert inverse(COBRA, pose, IkOptions(Limits.IGNORE)).status is IkStatus.FOUND


def test_the_last_joint_has_further_turns_the_slide_has_none() -> None:
    found = inverse(COBRA, forward(COBRA, [0.3, 0.8, 0.1, 0.2]))
    for q, turns in zip(found.solutions, found.turns, strict=True):
        np.testing.assert_allclose(turns - q, [[0.0, 0.0, 0.0, -2.0 * pi * np.sign(q[3])]], atol=EXACT)


def test_a_tilted_pose_is_told_by_its_tilt() -> None:
    level = forward(COBRA, [0.3, 0.8, 0.1, 0.2])
    tilted = level @ Pose(orientation=np.array([cos(0.1), sin(0.1), 0.0, 0.0]))
    found = inverse(COBRA, tilted)
    assert found.status is IkStatus.OUT_OF_TASK_SPACE
    assert found.shortfall is not None
    assert found.shortfall.miss is not None
    assert found.shortfall.miss.angle == pytest.approx(0.2)
    assert "cannot tilt" in found.shortfall.miss.why


@pytest.mark.parametrize("distance", [0.7, 0.02])
def test_a_point_out_of_reach_is_told_by_its_distance(distance: float) -> None:
    found = inverse(COBRA, Pose(np.array([0.0, distance, 0.2]), np.array([0.0, 1.0, 0.0, 0.0])))
    assert found.status is IkStatus.OUT_OF_REACH
    assert found.reach is not None
    assert found.reach.axis == "1"
    assert found.reach.distance == pytest.approx(distance)
    assert (found.reach.shortest, found.reach.longest) == pytest.approx((L1 - L2, L1 + L2))


def test_a_pose_of_the_column_out_of_reach_is_measured_from_its_first_rotation() -> None:
    robot, q = ARMS["column"], [0.1, 0.2, 0.3, 0.4]
    pose, across = forward(robot, q), joint_frames(robot, q)[1, :3, 0]
    found = inverse(robot, replace(pose, position=pose.position + 2.0 * across))
    assert found.status is IkStatus.OUT_OF_REACH
    assert found.reach is not None
    assert found.reach.axis == "2"
    assert found.reach.longest == pytest.approx(0.4 + 0.25)


def test_poses_as_people_type_them_are_taken() -> None:
    """Rounded to a thousandth of a millimetre and a ten-thousandth of a degree they are a little tilted."""
    pose = forward(COBRA, [0.3, 0.8, 0.1, 0.2])
    off = Pose(np.full(3, 5e-7), np.array([1.0, 4e-7, 4e-7, 0.0]))
    assert inverse(COBRA, pose @ off).status is IkStatus.FOUND


def test_where_the_wrist_is_on_axis_1_near_decides_joint_1() -> None:
    rows = tuple(replace(row, a=0.3) if k < 2 else row for k, row in enumerate(COBRA.dh))
    robot = arm(rows)
    q = np.array([0.7, pi, 0.1, 0.2])
    found = inverse(robot, forward(robot, q), IkOptions(Limits.IGNORE, near=q))
    assert apart(robot, found.solutions, q).min() < OWN
    assert hypot(*forward(robot, q).position[:2]) < EXACT


@pytest.mark.parametrize(
    ("robot", "reason"),
    [
        (random_arm(1, "RRPR"), "its axes are not all parallel"),
        (random_arm(1, "RRRR"), "4 of its joints turn, in the class 3 of 4"),
        (random_arm(1, "RRR"), "it has 3 joints, the class has 4"),
        (
            arm(
                (
                    DhRow(0.0, 0.0, 0.1),
                    DhRow(0.3, 0.0, 0.0),
                    DhRow(0.0, 0.0, 0.0),
                    DhRow(0.0, 0.0, 0.0, type=JointType.PRISMATIC),
                )
            ),
            "one of its two links has no length",
        ),
    ],
)
def test_other_arms_are_told_by_the_condition_that_they_miss(robot: RobotModel, reason: str) -> None:
    assert solver_of(robot).name != "SCARA"
    assert classes_missed(robot)["SCARA"] == reason


@pytest.mark.parametrize("broken", ["scaled", "mirrored", "nan"])
def test_matrices_that_are_no_poses_have_no_branches(broken: str) -> None:
    T = forward(COBRA, [0.3, 0.8, 0.1, 0.2]).matrix()
    T[:3, :3] *= {"scaled": 1.01, "mirrored": -1.0, "nan": np.nan}[broken]
    assert np.isnan(inverse_batch(COBRA, T[None])).all()
