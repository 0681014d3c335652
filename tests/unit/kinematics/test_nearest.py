"""The pose that comes nearest to one out of reach: on the edge of reach, within limits."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import NotFiniteError, forward, limit_violations, nearest
from ropsim.model import beside, on_track
from ropsim.robots import load
from ropsim.spatial import Pose
from support.published_arms import published_arm

PUMA = load("puma560")
MET = 1e-4  # m and rad: the search ends where its steps hardly help


def test_far_away_the_arm_is_stretched_towards_the_pose() -> None:
    """The wrist centre stops at 864.1 mm from axis 2; without a turn it lies 0 mm from the interface."""
    far = Pose(np.array([2.0, 0.1, 0.5]))
    found = nearest(PUMA, far)
    way = far.position - found.pose.position
    assert found.distance == pytest.approx(float(np.linalg.norm(way)))
    assert found.angle < MET
    shoulder = np.array([0.0, 0.0, 0.67183])
    reach = np.linalg.norm(found.pose.position - shoulder)
    assert reach == pytest.approx(np.hypot(0.4318 + np.hypot(0.4318, 0.0203), 0.15005), abs=MET)
    np.testing.assert_allclose(forward(PUMA, found.q).matrix(), found.pose.matrix(), atol=1e-12)
    assert not limit_violations(PUMA, found.q)


@pytest.mark.parametrize("name", ["ur5e_robot", "crx5ia", "franka_panda"])
def test_it_is_no_farther_than_the_stretched_arm_is_short(name: str) -> None:
    robot = published_arm(name)
    start = np.full(robot.n, 0.4)
    pose = forward(robot, start)
    assert nearest(robot, pose, start).distance < 1e-9
    away = Pose(pose.position * 10.0, pose.orientation)
    found = nearest(robot, away, start)
    assert found.distance < float(np.linalg.norm(away.position - pose.position))
    assert np.hypot(found.distance, found.angle) > 1.0


def test_external_axes_stand_still() -> None:
    track = on_track(PUMA, robots.linear_track(4.0))
    station = beside(track, robots.turntable(0.8), Pose(np.array([0.0, 1.5, 0.0])))
    q = np.array([*PUMA.home, 0.5, 0.3])
    pose = forward(station, q)
    away = Pose(pose.position + np.array([0.0, 5.0, 0.0]), pose.orientation)
    found = nearest(station, away, q)
    assert found.q[6:].tolist() == [0.5, 0.3]
    np.testing.assert_allclose(forward(station, found.q).matrix(), found.pose.matrix(), atol=1e-9)
    assert found.distance == pytest.approx(float(np.linalg.norm(away.position - found.pose.position)))


def test_a_pose_that_is_none_is_refused() -> None:
    with pytest.raises(NotFiniteError):
        nearest(PUMA, Pose(np.array([np.nan, 0.0, 0.0])))
