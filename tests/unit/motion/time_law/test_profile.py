"""The seven-segment profile: closed-form durations, limits, smoothness, exact ends."""

import math

import numpy as np
import pytest

from ropsim.motion import ProfileError, ProfileLimits, evaluate, plan_profile

ROUNDING = 1e-12  # relative; a handful of float64 operations
UNIT_DURATION = 3.1748021039  # 32^(1/3) s, the printed digits
UNIT_DIGITS = 1e-10  # half a unit of the last printed digit, and rounding

SHAPES = {
    "all seven segments": (10.0, ProfileLimits(1.0, 2.0, 8.0), 10.0 + 0.5 + 0.25),
    "speed limit without constant acceleration": (4.0, ProfileLimits(1.0, 10.0, 4.0), 4.0 + 2.0 * 0.5),
    "acceleration limit without constant speed": (1.5, ProfileLimits(10.0, 1.0, 2.0), 3.0),
    "jerk limit only": (1.0, ProfileLimits(10.0, 10.0, 32.0), 1.0),
}


def test_unit_distance_with_unit_limits_takes_the_cube_root_of_32_seconds() -> None:
    profile = plan_profile(1.0, ProfileLimits(1.0, 1.0, 1.0))
    assert profile.duration == pytest.approx(UNIT_DURATION, abs=UNIT_DIGITS)
    assert profile.duration == pytest.approx(32.0 ** (1.0 / 3.0), rel=ROUNDING)


@pytest.mark.parametrize(("distance", "limits", "duration"), SHAPES.values(), ids=SHAPES.keys())
def test_durations_of_all_shapes_are_those_of_hand_computation(
    distance: float, limits: ProfileLimits, duration: float
) -> None:
    assert plan_profile(distance, limits).duration == pytest.approx(duration, rel=ROUNDING)


@pytest.mark.parametrize(("distance", "limits", "duration"), SHAPES.values(), ids=SHAPES.keys())
def test_speed_is_the_integral_of_acceleration_and_way_that_of_speed(
    distance: float, limits: ProfileLimits, duration: float
) -> None:
    profile = plan_profile(distance, limits)
    t = np.linspace(0.0, duration, 200_001)
    way, speed, acceleration = evaluate(profile, t)
    step = t[1]
    coarse = 1e-8  # trapezoidal rule with 200 000 steps, errors of the order of jerk·step²
    assert np.abs(np.cumsum((speed[1:] + speed[:-1]) / 2.0) * step - way[1:]).max() < coarse
    assert np.abs(np.cumsum((acceleration[1:] + acceleration[:-1]) / 2.0) * step - speed[1:]).max() < coarse


@pytest.mark.parametrize(("distance", "limits", "duration"), SHAPES.values(), ids=SHAPES.keys())
def test_way_speed_and_acceleration_have_no_jumps(
    distance: float, limits: ProfileLimits, duration: float
) -> None:
    step = 1e-6
    profile = plan_profile(distance, limits)
    edges = np.cumsum([profile.jerk_time, profile.acceleration_time, profile.jerk_time])
    edges = np.concatenate((edges, [duration / 2.0], duration - edges))
    before, after = evaluate(profile, edges - step), evaluate(profile, edges + step)
    bounds = (limits.speed, limits.acceleration, limits.jerk)
    for left, right, bound in zip(before, after, bounds, strict=True):
        assert np.abs(right - left).max() <= 2.0 * step * bound * (1.0 + 1e-3)


def test_profile_starts_and_ends_exactly_and_at_rest() -> None:
    profile = plan_profile(0.7, ProfileLimits(0.3, 1.7, 11.0))
    way, speed, acceleration = evaluate(profile, np.array([0.0, profile.duration]))
    assert way.tolist() == [0.0, 0.7]
    assert speed.tolist() == [0.0, 0.0]
    assert np.abs(acceleration).tolist() == [0.0, 0.0]


def test_profile_stands_still_before_its_start_and_after_its_end() -> None:
    profile = plan_profile(0.7, ProfileLimits(0.3, 1.7, 11.0))
    way, speed, _ = evaluate(profile, np.array([-1.0, profile.duration + 1.0]))
    assert way.tolist() == [0.0, 0.7]
    assert speed.tolist() == [0.0, 0.0]


def test_peaks_are_the_limits_where_they_are_reached() -> None:
    profile = plan_profile(10.0, ProfileLimits(1.0, 2.0, 8.0))
    assert profile.peak_speed == pytest.approx(1.0, rel=ROUNDING)
    assert profile.peak_acceleration == pytest.approx(2.0, rel=ROUNDING)


def test_no_distance_takes_no_time() -> None:
    profile = plan_profile(0.0, ProfileLimits(1.0, 1.0, 1.0))
    assert profile.duration == 0.0
    assert [values.tolist() for values in evaluate(profile, np.array([0.0, 1.0]))] == [[0.0, 0.0]] * 3


@pytest.mark.parametrize("bad", [0.0, -1.0, math.nan, math.inf])
def test_limits_that_no_motion_can_have_are_refused(bad: float) -> None:
    for limits in (ProfileLimits(bad, 1, 1), ProfileLimits(1, bad, 1), ProfileLimits(1, 1, bad)):
        with pytest.raises(ProfileError, match="allowed are numbers above 0"):
            plan_profile(1.0, limits)


@pytest.mark.parametrize("bad", [-1.0, math.nan, math.inf])
def test_distances_that_no_motion_can_have_are_refused(bad: float) -> None:
    with pytest.raises(ProfileError, match="allowed is 0 or more"):
        plan_profile(bad, ProfileLimits(1, 1, 1))
