"""How far closed chains follow a motion of the axes, and the limits that they set to it."""

from dataclasses import replace

import numpy as np

from ropsim.kinematics import Obstacle, follower_limits, limit_violations, loop_passage
from ropsim.model import LoopCut, RobotModel
from support.closed_arms import COUPLED_PALLETIZER, lengths_of, palletizer, two_link_with_cylinders
from support.linkages import CRANK, IN_PLANE, SLIDER_CRANK, at

SHORT_ROD = 0.15
LOCKED_AT = np.arcsin(SHORT_ROD / CRANK)  # the rod stands upright: sin q = l/r


def short_rod() -> RobotModel:
    """Return a slider-crank whose rod is shorter than its crank: it locks before the crank stands upright."""
    crank, rod, slider = SLIDER_CRANK.joints
    return replace(
        SLIDER_CRANK,
        joints=(crank, rod, replace(slider, placement=at(CRANK + SHORT_ROD) @ slider.placement)),
        cuts=(LoopCut(1, at(SHORT_ROD), 2, at(0.0), IN_PLANE),),
    )


def test_a_rod_that_is_shorter_than_its_crank_locks_at_its_dead_centre() -> None:
    rows = np.linspace(0.05, 1.4, 1351)[:, np.newaxis]
    found = loop_passage(short_rod(), rows)
    assert found.obstacle is Obstacle.LOCKED
    assert abs(rows[found.rows - 1, 0] - LOCKED_AT) <= 1e-3


def test_a_motion_that_stays_before_the_dead_centre_is_let_through() -> None:
    rows = np.linspace(0.05, LOCKED_AT - 1e-3, 50)[:, np.newaxis]
    found = loop_passage(short_rod(), rows)
    assert (found.rows, found.obstacle) == (50, None)


def test_a_motion_that_begins_beyond_it_goes_nowhere() -> None:
    found = loop_passage(short_rod(), [[1.2], [1.1]])
    assert (found.rows, found.obstacle) == (0, Obstacle.LOCKED)


def test_parallelograms_and_open_arms_go_anywhere() -> None:
    rows = COUPLED_PALLETIZER.home + np.linspace(0.0, 1.0, 9)[:, np.newaxis] * np.array([1.0, 0.3, -0.3, 2.0])
    for robot in (palletizer(), COUPLED_PALLETIZER):
        assert loop_passage(robot, rows).obstacle is None


def test_passive_joints_and_gaps_have_limits() -> None:
    robot = two_link_with_cylinders()
    limits = follower_limits(robot)
    names = [joint.name for joint in limits.joints]
    assert names[:2] == ["shoulder", "elbow"]
    assert names[-2:] == ["gap of closed chain 1", "gap of closed chain 2"]
    inside, beyond = lengths_of(1.0, -1.4), np.array([0.7, 0.74])
    np.testing.assert_allclose(limits.values(inside)[:2], [1.0, -1.4], atol=1e-9)
    assert not limits.excess(inside).any()
    assert limits.excess(beyond)[-2] > 0.05  # the triangle of the first cylinder ends at 0.594 m
    assert {one.name for one in limit_violations(robot, beyond)} >= {"gap of closed chain 1"}


def test_a_passive_joint_beyond_its_limit_is_named() -> None:
    robot = two_link_with_cylinders()
    low = lengths_of(-0.1, -1.4)  # the shoulder has 0° as its lower limit
    found = {one.name for one in limit_violations(robot, low)}
    assert "shoulder" in found


def test_values_are_of_the_same_shape_as_their_configurations() -> None:
    limits = follower_limits(two_link_with_cylinders())
    rows = np.array([lengths_of(1.0, -1.4), [np.nan, 0.7]])
    assert limits.values(rows).shape == (2, len(limits.joints))
    assert np.isnan(limits.excess(rows)[1]).all()
