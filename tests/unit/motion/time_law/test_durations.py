"""Durations of synchronous pose-to-pose moves: the slowest joint leads."""

import math

import numpy as np
import pytest

from ropsim.motion import JointMotionLimits, ProfileError, durations
from ropsim.spatial import Array

ROUNDING = 1e-12
LIMITS = JointMotionLimits(np.array([1.0, 2.0]), np.array([4.0, 8.0]), np.array([40.0, 80.0]))
ORIGIN = np.zeros(2)


def duration(goal: list[float]) -> float:
    return float(durations(ORIGIN, np.array([goal]), LIMITS)[0])


def test_one_joint_alone_takes_the_time_of_its_profile() -> None:
    # 10 rad at 1 rad/s: 10 s at speed, and the ramp of 4/40 + 1/4 s
    assert duration([10.0, 0.0]) == pytest.approx(10.35, rel=ROUNDING)


def test_the_slowest_joint_leads() -> None:
    alone = duration([1.0, 0.0])
    assert duration([1.0, 1.9]) == alone
    assert duration([1.0, 2.1]) > alone


@pytest.mark.parametrize("way", [0.0, 5e-10])
def test_a_move_of_no_length_takes_no_time(way: float) -> None:
    assert duration([way, 0.0]) == 0.0


def test_many_goals_take_the_times_that_they_take_alone() -> None:
    goals: Array = np.array([[1.0, 0.2], [0.0, 0.0], [-0.3, 2.0]])
    assert durations(ORIGIN, goals, LIMITS).tolist() == [duration(goal) for goal in goals.tolist()]


@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_coordinates_that_are_not_finite_are_refused(bad: float) -> None:
    with pytest.raises(ProfileError, match="M540"):
        duration([bad, 0.0])


def test_a_limit_of_zero_is_refused() -> None:
    with pytest.raises(ProfileError, match="M540"):
        durations(ORIGIN, np.ones((1, 2)), JointMotionLimits(np.array([1.0, 0.0]), np.ones(2), np.ones(2)))


def test_limits_cannot_be_changed() -> None:
    with pytest.raises(ValueError, match="read-only"):
        LIMITS.speed[0] = 2.0
