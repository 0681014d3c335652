"""Arms with a spherical wrist behind three joints of which one slides: the Stanford arm and its like."""

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
    posture,
    solver_of,
)
from ropsim.kinematics.testing import numeric
from ropsim.model import DhRow, JointType, RobotModel
from ropsim.spatial import Array, Pose
from support.wrist_arms import arm

EXACT = 1e-9
"""Promised of answers [rad | m]."""
BEND = 1e-7
"""Rounding where two branches nearly meet [rad | m]."""
SLIDE = JointType.PRISMATIC
TILTED = Pose(np.array([0.4, -0.2, 1.0]), np.array([0.8, 0.3, -0.4, 0.1]))
FLANGE = Pose(np.array([0.01, 0.02, 0.03]), np.array([0.5, 0.1, 0.7, -0.2]))
WRIST = (
    DhRow(a=0.0, alpha=-pi / 2, d=0.3, theta=0.2),
    DhRow(a=0.0, alpha=pi / 2, d=0.0, theta=-0.4),
    DhRow(a=0.0, alpha=0.0, d=0.1, theta=pi),
)


def skew() -> RobotModel:
    """Return an arm like the Stanford arm, no two of its first axes perpendicular, on a tilted base."""
    rows = (
        DhRow(a=0.0, alpha=-1.1, d=0.4, theta=0.3),
        DhRow(a=0.15, alpha=1.3, d=0.2, theta=-0.6),
        DhRow(a=0.05, alpha=0.7, d=0.1, theta=0.5, type=SLIDE),
    )
    return arm((*rows, *WRIST), TILTED, FLANGE)


def lifted(place: int) -> RobotModel:
    """Return an arm with two parallel axes and a slide along them at one of three places."""
    rows = [DhRow(a=0.4, alpha=pi, d=0.1, theta=0.3), DhRow(a=0.25, alpha=0.0, d=0.05, theta=-0.7)]
    rows.insert(place, DhRow(a=0.02, alpha=0.0, d=0.2, theta=0.4, type=SLIDE))
    rows[2] = replace(rows[2], alpha=0.8)
    return arm((*rows, *WRIST), TILTED, FLANGE)


ARMS = {"stanford": robots.load("stanford"), "skew": skew()} | {f"lifted {k}": lifted(k) for k in range(3)}


def configurations(robot: RobotModel, count: int) -> Array:
    rng = np.random.default_rng(8)
    limits = [
        (max(one.lower, 0.2), min(one.upper, 1.3))
        if one.type is SLIDE
        else (max(one.lower, -pi), min(one.upper, pi))
        for one in robot.joints
    ]
    low, high = np.array(limits).T
    return rng.uniform(low, high, (count, 6))


def apart(robot: RobotModel, found: Array, Q: Array) -> Array:
    """Return how far the nearest row is from the configuration that made the pose, shape (k,)."""
    off = found - Q[:, np.newaxis]
    turns = 2.0 * pi * np.array([one.type is not SLIDE for one in robot.joints])
    off -= turns * np.round(off / (2.0 * pi))
    return np.asarray(np.nan_to_num(np.abs(off).max(axis=2), nan=np.inf).min(axis=1))


def test_ten_thousand_poses_of_the_stanford_arm_have_the_configuration_that_made_them() -> None:
    robot = ARMS["stanford"]
    Q = np.random.default_rng(8).uniform(robot.lower_limits, robot.upper_limits, (10_000, 6))
    poses = forward_batch(robot, Q)
    found = inverse_batch(robot, poses)
    assert not np.isnan(found).any()  # a slide without limits: eight branches wherever the boom reaches
    assert apart(robot, found, Q).max() < EXACT
    few = slice(None, None, 50)
    again = forward_batch(robot, found[few].reshape(-1, 6))
    assert np.abs(again - np.repeat(poses[few], 8, axis=0)).max() < EXACT


@pytest.mark.parametrize("name", ARMS)
def test_all_answers_of_a_search_are_among_the_branches_and_postures_name_the_rows(name: str) -> None:
    robot = ARMS[name]
    solver = solver_of(robot)
    assert (solver.name, solver.method) == ("sliding joint, spherical wrist", Method.CLOSED_FORM)
    assert len(solver.postures) == (4 if name.startswith("lifted") else 8)
    Q = configurations(robot, 40)
    poses = forward_batch(robot, Q)
    found = inverse_batch(robot, poses)
    assert apart(robot, found, Q).max() < BEND
    for rows in found:
        assert all(posture(robot, q) == solver.postures[k] for k, q in enumerate(rows) if q[0] == q[0])
    searched = numeric(robot).branches(poses[:2], np.zeros(6))
    for rows, others in zip(found, searched, strict=False):
        answers = others[~np.isnan(others[:, 0])]
        assert len(answers) >= 2
        assert apart(robot, np.tile(rows, (len(answers), 1, 1)), answers).max() < BEND


def test_solutions_of_the_stanford_arm_are_named_and_within_its_limits() -> None:
    robot = ARMS["stanford"]
    for q in configurations(robot, 20):
        found = inverse(robot, forward(robot, np.clip(q, robot.lower_limits, robot.upper_limits)))
        assert found.status is IkStatus.FOUND
        assert {str(one).split("-")[1] for one in found.postures} == {"out"}  # its boom is not drawn through
        assert (found.solutions >= robot.lower_limits).all()
        assert (found.solutions <= robot.upper_limits).all()


def test_words_of_the_stanford_arm_say_where_axis_2_moves_the_boom() -> None:
    """At q2 = 90° the boom is level; a positive turn lowers it, over the shoulder it raises it."""
    robot = ARMS["stanford"]
    for q2, side in ((1.5, "right"), (-1.5, "left")):
        q = np.array([0.2, q2, 0.8, 0.3, 0.4, 0.5])
        up = [
            forward(robot, q + np.array([0.0, turn, 0.0, 0.0, 0.0, 0.0])).position[2] for turn in (0.0, 0.01)
        ]
        assert (up[1] < up[0]) == (side == "right")
        assert posture(robot, q) == Posture((side, "out", posture(robot, q).words[2]))


def test_a_straight_wrist_keeps_joint_4_and_a_place_too_near_is_told() -> None:
    robot = ARMS["stanford"]
    q = np.array([0.3, 1.2, 0.9, 0.7, 0.0, -0.4])
    found = inverse(robot, forward(robot, q), IkOptions(near=q))
    assert np.abs(found.solutions - q).max(axis=1).min() < EXACT
    # 154 mm beside axis 1 is as near as the wrist comes to it (Stanford AIM-177, figure 2.3)
    down = Pose(np.array([0.05, 0.0, 1.0 - 0.263]), np.array([0.0, 1.0, 0.0, 0.0]))
    reach = inverse(robot, down, IkOptions(limits=Limits.IGNORE)).reach
    assert reach is not None
    assert (reach.point, reach.axis) == ("wrist centre", "1")
    assert (reach.distance, reach.shortest) == pytest.approx((0.05, 0.154), abs=1e-9)
    inner = Pose(np.array([0.05, 0.0, 0.412 - 0.263]), np.array([0.0, 1.0, 0.0, 0.0]))
    reach = inverse(robot, inner).reach
    assert reach is not None
    assert reach.axis == "2"
    assert reach.shortest == pytest.approx(0.154)


def test_rounded_right_angles_are_snapped_and_answers_reach_the_pose_of_the_arm_as_it_is() -> None:
    exact = skew()
    rows = tuple(replace(one, alpha=round(one.alpha, 4)) for one in exact.dh)
    robot = arm(rows, TILTED, FLANGE)
    assert 0.0 < solver_of(robot).snapped_by.angle < 1e-4
    Q = configurations(robot, 40)
    found = inverse_batch(robot, forward_batch(robot, Q))
    assert apart(robot, found, Q).max() < 1e-6


def test_arms_of_other_geometry_miss_the_class_by_a_reason() -> None:
    name = "sliding joint, spherical wrist"
    rows = skew().dh
    offset = arm((replace(rows[0], a=0.1), *rows[1:]))
    assert classes_missed(offset)[name] == "axes 1 and 2 do not meet"
    loose = arm((*rows[:4], replace(rows[4], a=0.02), rows[5]))
    assert classes_missed(loose)[name] == "axes 4, 5 and 6 do not meet in one point"
    first = arm((replace(rows[0], type=SLIDE), rows[1], replace(rows[2], type=JointType.REVOLUTE), *rows[3:]))
    assert classes_missed(first)[name].startswith("its slide is no third joint")
    assert solver_of(offset).method is Method.NUMERIC
