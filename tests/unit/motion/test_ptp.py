"""Synchronous pose-to-pose motion: the slowest joint leads, the others keep step."""

import math

import numpy as np
import pytest

from ropsim.motion import JointMotionLimits, ProfileError, durations, joint_trajectory

ROUNDING = 1e-12
LIMITS = JointMotionLimits(np.array([1.0, 2.0]), np.array([4.0, 8.0]), np.array([40.0, 80.0]))
ORIGIN = np.zeros(2)


def test_one_joint_alone_takes_the_time_of_its_profile() -> None:
    # 10 rad at 1 rad/s: 10 s at speed, and the ramp of 4/40 + 1/4 s
    trajectory = joint_trajectory(ORIGIN, np.array([10.0, 0.0]), LIMITS)
    assert trajectory.duration == pytest.approx(10.35, rel=ROUNDING)


def test_the_slowest_joint_leads() -> None:
    alone = joint_trajectory(ORIGIN, np.array([1.0, 0.0]), LIMITS)
    together = joint_trajectory(ORIGIN, np.array([1.0, 1.9]), LIMITS)
    assert together.duration == alone.duration
    longer = joint_trajectory(ORIGIN, np.array([1.0, 2.1]), LIMITS)
    assert longer.duration > alone.duration


def test_joints_keep_step_at_every_time() -> None:
    trajectory = joint_trajectory(ORIGIN, np.array([1.0, -0.5]), LIMITS)
    q = trajectory.joints(np.linspace(0.0, trajectory.duration, 50))
    assert q[:, 1] == pytest.approx(-0.5 * q[:, 0], abs=ROUNDING)


def test_start_and_end_are_exact() -> None:
    start, end = np.array([0.1, -0.7]), np.array([0.3, 1.1])
    trajectory = joint_trajectory(start, end, LIMITS)
    q = trajectory.joints(np.array([0.0, trajectory.duration]))
    assert q.tolist() == [start.tolist(), end.tolist()]


def test_derivatives_are_those_of_the_joint_coordinates() -> None:
    trajectory = joint_trajectory(ORIGIN, np.array([1.0, -0.5]), LIMITS)
    t, step = np.linspace(0.05, trajectory.duration - 0.05, 40), 1e-5
    before, now, after = (trajectory.joints(t + shift) for shift in (-step, 0.0, step))
    speed, acceleration = trajectory.derivatives(t)
    assert speed == pytest.approx((after - before) / (2.0 * step), abs=1e-7)
    assert acceleration == pytest.approx((after - 2.0 * now + before) / step**2, abs=1e-3)


@pytest.mark.parametrize("way", [0.0, 5e-10])
def test_a_move_of_no_length_takes_no_time(way: float) -> None:
    assert joint_trajectory(ORIGIN, np.array([way, 0.0]), LIMITS).duration == 0.0


def test_a_stretched_move_ends_at_the_same_place_at_the_time_asked_for() -> None:
    end = np.array([1.0, -0.5])
    trajectory = joint_trajectory(ORIGIN, end, LIMITS).stretched(2.0)
    assert trajectory.duration == 2.0
    assert trajectory.joints(np.array([2.0]))[0].tolist() == end.tolist()


def test_durations_of_many_goals_are_those_of_their_trajectories() -> None:
    goals = np.array([[1.0, 0.2], [0.0, 0.0], [-0.3, 2.0]])
    expected = [joint_trajectory(ORIGIN, goal, LIMITS).duration for goal in goals]
    assert durations(ORIGIN, goals, LIMITS).tolist() == expected


@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_coordinates_that_are_not_finite_are_refused(bad: float) -> None:
    with pytest.raises(ProfileError, match="M540"):
        joint_trajectory(ORIGIN, np.array([bad, 0.0]), LIMITS)


def test_a_record_of_a_trajectory_cannot_be_changed() -> None:
    trajectory = joint_trajectory(ORIGIN, np.ones(2), LIMITS)
    with pytest.raises(ValueError, match="read-only"):
        trajectory.q_end[0] = 2.0
