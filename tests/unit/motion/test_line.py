"""Straight lines: one profile for position and orientation, the stricter limit leads."""

import math

import numpy as np
import pytest

from ropsim.motion import LineLimits, ProfileError, line_trajectory
from ropsim.spatial import Pose

ROUNDING = 1e-12
LIMITS = LineLimits(0.25, 2.0, 20.0, 1.0, 8.0, 80.0)


def turned(angle: float, *, x: float = 0.0) -> Pose:
    """Return a pose at x [m], turned about z by an angle [rad]."""
    return Pose(np.array([x, 0.0, 0.0]), np.array([math.cos(angle / 2.0), 0.0, 0.0, math.sin(angle / 2.0)]))


def test_a_pure_translation_takes_the_time_of_its_speed_and_ramp() -> None:
    # 1 m at 0.25 m/s, and the ramp of 2/20 + 0.25/2 s
    assert line_trajectory(Pose(), turned(0.0, x=1.0), LIMITS).duration == pytest.approx(4.225, rel=ROUNDING)


def test_a_pure_turn_takes_the_time_of_its_angular_speed_and_ramp() -> None:
    # 2 rad at 1 rad/s, and the ramp of 8/80 + 1/8 s
    assert line_trajectory(Pose(), turned(2.0), LIMITS).duration == pytest.approx(2.225, rel=ROUNDING)


def test_the_slower_of_way_and_turn_leads() -> None:
    way, turn = turned(0.0, x=1.0), turned(2.0)
    assert line_trajectory(Pose(), turned(0.1, x=1.0), LIMITS).duration == pytest.approx(
        line_trajectory(Pose(), way, LIMITS).duration, rel=ROUNDING
    )
    assert line_trajectory(Pose(), turned(2.0, x=0.01), LIMITS).duration == pytest.approx(
        line_trajectory(Pose(), turn, LIMITS).duration, rel=ROUNDING
    )


def test_half_the_time_is_half_the_way_and_half_the_turn() -> None:
    trajectory = line_trajectory(Pose(), turned(2.0, x=1.0), LIMITS)
    middle = trajectory.matrices(np.array([trajectory.duration / 2.0]))[0]
    assert np.abs(middle - turned(1.0, x=0.5).matrix()).max() < ROUNDING


def test_the_tool_turns_the_short_way() -> None:
    trajectory = line_trajectory(turned(3.0), turned(-3.0), LIMITS)
    assert trajectory.turn.angle == pytest.approx(2.0 * math.pi - 6.0, rel=ROUNDING)


def test_speed_of_the_tcp_is_constant_on_the_plateau() -> None:
    trajectory = line_trajectory(Pose(), turned(0.1, x=1.0), LIMITS)
    speed, turning = trajectory.speeds(np.linspace(0.5, 3.5, 11))
    assert speed == pytest.approx(np.full(11, 0.25), rel=ROUNDING)
    assert turning == pytest.approx(np.full(11, 0.025), rel=ROUNDING)


def test_a_line_keeps_its_speed_when_it_is_stretched_a_little() -> None:
    trajectory = line_trajectory(Pose(), turned(0.0, x=1.0), LIMITS).stretched(4.228)
    assert trajectory.duration == 4.228
    assert trajectory.speeds(np.array([2.0]))[0][0] == pytest.approx(0.25, rel=ROUNDING)


def test_a_line_of_no_length_and_no_turn_takes_no_time() -> None:
    trajectory = line_trajectory(turned(1.0), turned(1.0), LIMITS)
    assert trajectory.duration == 0.0
    assert trajectory.matrices(np.empty(0)).shape == (0, 4, 4)


def test_rounding_of_an_orientation_that_is_kept_does_not_limit_the_speed() -> None:
    trajectory = line_trajectory(turned(0.0), turned(1e-12, x=1.0), LIMITS)
    assert trajectory.duration == pytest.approx(4.225, rel=ROUNDING)


def test_a_limit_of_zero_is_refused() -> None:
    with pytest.raises(ProfileError, match="M540"):
        line_trajectory(Pose(), turned(0.0, x=1.0), LineLimits(0.0, 2.0, 20.0, 1.0, 8.0, 80.0))
